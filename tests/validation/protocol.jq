# The one setting that all landslides of the group "blind" are run with; README.md, "Blind".
# No value of it was chosen by a landslide, and none may be changed for one.
def protocol:
  (.materials[] | select(.softening)) |= (
    .softening.regularization = "band" | .softening.band_m = 2
    | .rate = {"law": "semi-logarithmic", "per_decade": 0.10, "reference_rate_per_s": 1.4e-5})
  | .materials[.layers[0].material].tensile_strength_kPa = 0
  | .resolution = {"cell_m": 1, "particles_per_cell": 4};
