# The one setting that all landslides of the group "blind" are run with; README.md, "Blind".
# No value of it was chosen by a landslide, and none may be changed for one.
def protocol:
  (.materials[] | select(.softening)) |= (
    .softening.regularization = "band" | .softening.band_m = 2
    | .rate = {"law": "semi-logarithmic", "per_decade": 0.10, "reference_rate_per_s": 1.4e-5})
  | .materials[.layers[0].material].tensile_strength_kPa = 0
  | .resolution = {"cell_m": 1, "particles_per_cell": 4};

# The same with the ground as the sources have it: a crust that drains, above the water table, and
# in a row's own columns a far bank that stood.
def crust: .layers[0].material;
def protocol_of_known_ground:
  protocol
  | crust as $crust | .layers[0].thickness_m as $thickness
  | .materials[$crust] |= (del(.tensile_strength_kPa) | .drainage = "drained"
      | .drained //= {"cohesion_kPa": 0, "friction_angle_deg": 35})
  | .water_table = {"depth_m": $thickness};

# Ground beyond x that does not soften, in place of the clay named, with its strength.
def far_bank($x; $clay; $strength):
  .materials["far bank"] = (.materials[$clay] | del(.softening, .rate) | .peak_strength_kPa = $strength)
  | .layers as $layers | (.ground | first[0]) as $left | (.ground | last[0]) as $right
  | ($layers | map(if .material == $clay then .material = "far bank" else . end)) as $far
  | .columns = (if $x > 0 then [{"from_m": $left, "to_m": $x, "layers": $layers},
                                {"from_m": $x, "to_m": $right, "layers": $far}]
                else [{"from_m": $left, "to_m": -$x, "layers": $far},
                      {"from_m": -$x, "to_m": $right, "layers": $layers}] end)
  | del(.layers);
