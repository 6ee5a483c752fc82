#include "solver/statics/stiffness.hpp"

#include <array>
#include <cmath>

namespace leda::solver {

namespace {

constexpr std::size_t nodes = 9, axes = 2;

// Slopes of the nine splines at a point, column by column, 1/m; `f` is the distance from the
// lowest node in cells (0.5 to 1.5), as in spline-inl.hpp.
struct Slopes {
  std::array<double, nodes> x, z;
};

Slopes slopes_at(double fx, double fz, double h) {
  const auto weight = [](double f) {
    const double a = 1.5 - f, b = f - 1, c = f - 0.5;
    return std::array<double, 3>{0.5 * a * a, 0.75 - b * b, 0.5 * c * c};
  };
  const auto slope = [h](double f) {
    return std::array<double, 3>{(f - 1.5) / h, -2 * (f - 1) / h, (f - 0.5) / h};
  };
  const auto wx = weight(fx), wz = weight(fz), sx = slope(fx), sz = slope(fz);
  Slopes s{};
  for (std::size_t n = 0; n < nodes; ++n) {
    s.x[n] = sx[n / 3] * wz[n % 3];
    s.z[n] = wx[n / 3] * sz[n % 3];
  }
  return s;
}

// Stiffness among the nodes of one span; of the pairs of nodes only the lower half is kept.
class SpanStiffness {
 public:
  // volume per metre, m2; moduli in Pa
  void add(const Slopes& s, double volume, double shear, double bulk) {
    add(s, volume * (bulk - 2.0 / 3.0 * shear), volume * shear);
  }

  // The same with the dilation left to its mean over the span: what stays is the in-plane shear,
  // and add_mean_dilation() brings the rest once all particles of the span are known.
  void add_averaged(const Slopes& s, double volume, double shear, double bulk) {
    add(s, -volume * shear, volume * shear);
    for (std::size_t n = 0; n < nodes; ++n) {
      dilation_[n * axes] += volume * s.x[n];
      dilation_[n * axes + 1] += volume * s.z[n];
    }
    volume_ += volume;
    modulus_ += volume * (bulk + shear / 3);
  }

  void add_mean_dilation() {
    const double scale = modulus_ / (volume_ * volume_);
    for (std::size_t a = 0; a < nodes; ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        for (std::size_t i = 0; i < axes * axes; ++i) {
          k_[(a * nodes + b) * axes * axes + i] +=
              scale * dilation_[a * axes + i / axes] * dilation_[b * axes + i % axes];
        }
      }
    }
  }

  void add_to(ColumnMatrix& matrix, const std::array<Freedom, nodes * axes>& at) const {
    for (std::size_t i = 0; i < nodes * axes; ++i) {
      if (at[i].number < 0) continue;
      for (std::size_t j = 0; j < nodes * axes; ++j) {
        if (at[j].number < 0 || at[j].number > at[i].number) continue;
        matrix.add(at[i].number, at[j].number, at[i].sign * at[j].sign * entry(i, j));
      }
    }
  }

 private:
  void add(const Slopes& s, double lame, double g) {
    const double direct = lame + 2 * g;
    for (std::size_t a = 0; a < nodes; ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        double* k = &k_[(a * nodes + b) * axes * axes];
        k[0] += direct * s.x[a] * s.x[b] + g * s.z[a] * s.z[b];
        k[1] += lame * s.x[a] * s.z[b] + g * s.z[a] * s.x[b];
        k[2] += lame * s.z[a] * s.x[b] + g * s.x[a] * s.z[b];
        k[3] += direct * s.z[a] * s.z[b] + g * s.x[a] * s.x[b];
      }
    }
  }

  double entry(std::size_t i, std::size_t j) const {
    const std::size_t a = i / axes, b = j / axes;
    if (b <= a) return k_[(a * nodes + b) * axes * axes + i % axes * axes + j % axes];
    return k_[(b * nodes + a) * axes * axes + j % axes * axes + i % axes];
  }

  std::array<double, nodes * nodes * axes * axes> k_{};
  std::array<double, nodes * axes> dilation_{};  // sum V grad w, m
  double volume_ = 0, modulus_ = 0;              // sums of V and of V (lame + G)
};

void fill(SpanStiffness& span, double h, double volume, double shear, double bulk) {
  const double apart = 0.5 / std::sqrt(3.0);  // Gauss points, 2 x 2
  for (const double fx : {1 - apart, 1 + apart}) {
    for (const double fz : {1 - apart, 1 + apart}) {
      span.add(slopes_at(fx, fz, h), volume / 4, shear, bulk);
    }
  }
}

}  // namespace

ColumnMatrix elastic_stiffness(const Particles& p, const LawTable& laws, const Grid& grid,
                               const Freedoms& freedoms, double filling) {
  ColumnMatrix matrix(freedoms);
  const double per_h = 1 / grid.h;
  const auto column = [&](std::size_t i) { return std::floor(p.x[i] * per_h + 0.5); };
  const auto row = [&](std::size_t i) { return std::floor(p.z[i] * per_h + 0.5); };
  for (std::size_t i = 0; i < p.count;) {
    const double c = column(i), r = row(i);
    SpanStiffness span;
    const auto first = static_cast<std::size_t>(p.law[i]);
    fill(span, grid.h, filling * grid.h * grid.h, laws.shear[first], laws.bulk[first]);
    for (; i < p.count && column(i) == c && row(i) == r; ++i) {
      const auto law = static_cast<std::size_t>(p.law[i]);
      const Slopes slopes = slopes_at(p.x[i] * per_h + 1 - c, p.z[i] * per_h + 1 - r, grid.h);
      if (grid.averages()) {
        span.add_averaged(slopes, p.volume[i], laws.shear[law], laws.bulk[law]);
      } else {
        span.add(slopes, p.volume[i], laws.shear[law], laws.bulk[law]);
      }
    }
    if (grid.averages()) span.add_mean_dilation();
    std::array<Freedom, nodes * axes> at;
    for (std::size_t n = 0; n < nodes * axes; ++n) {
      const std::size_t node = n / axes;
      at[n] = freedoms.at(grid, static_cast<std::size_t>(c) + node / 3,
                          static_cast<std::size_t>(r) + node % 3)[n % axes];
    }
    span.add_to(matrix, at);
  }
  return matrix;
}

}  // namespace leda::solver
