#pragma once
// How large a model of a section is, and how fast waves cross it.

#include "solver/section/run_settings.hpp"
#include "solver/section/section.hpp"

namespace leda {

/// Of the ground above the base, m2; negative parts count against it.
double ground_area(const Section& section);

/// Particles that fill the ground, about.
double particles_of(const Section& section, const Resolution& resolution);

/// Of compression waves, m/s: c_p^2 = (K + 4/3 G) / rho.
double p_wave_speed(const Material& material);

}  // namespace leda
