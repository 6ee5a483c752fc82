# The hindcast over the landslides of the thesis, from the cases of the group "blind-ground":
#   jq -n -L .. -f hindcast.jq --slurpfile CASE FILE ... (make.sh)
# Coarser than that group: cells of 2 m and a band of 4 m (the long valleys 3.75 and 7.5 m). The slip over
# which the strength is lost is the same in a band of any thickness, so that the work of slip is kept.
include "protocol";

# A clay's strength as a profile, so that one path scales the strength of every clay.
def as_profile: if type == "number" then {"at_elevation_m": [[0, .], [50, .]]} else . end;

def coarse($cell; $time):
  .resolution.cell_m = $cell | .stop.max_time_s = $time
  | (.materials[] | select(.softening))
    |= (.softening.band_m = 2 * $cell | .peak_strength_kPa |= as_profile);

def event($name; $case; $observed; $source):
  {name: $name, case: ($case | .name = $name), observed: $observed, source: $source};

def sainte_monique:
  protocol_of_known_ground
  | (.materials.S1, .materials.B1).peak_strength_kPa =
      {"at_elevation_m": [[-3.3, 70], [1.7, 50], [11.6, 30], [11.7, 25], [19.7, 25]]}
  | .ground[0][0] = -250 | far_bank(222; "S1"; 40);

def saint_jude:
  protocol_of_known_ground
  | .ground[0:3] = [[0, 32.5], [119, 32.5], [174.5, 9.5]] | .layers[1].bottom_m = 7
  | .crest_m = [265.7, 32.5] | .toe_m = [187.5, 9.5] | far_bank(-181; "S2"; 55);

def saint_luc: protocol_of_known_ground | .ground[0][0] = -220 | .ground[5][0] = 582;

# 400 m more plain than in "blind-ground", so that a retrogression too far is seen to be so.
def lemieux: protocol_of_known_ground | .ground[-1][0] = 2000;

{
  name: "sensitive clay of eastern Canada",
  events: [
    event("Sainte-Monique 1994"; $monique[0] | sainte_monique | coarse(2; 120);
      {retrogression_m: {value: 100, sd_ln: 0.05}, runout_m: {value: 52, sd_ln: 0.1}};
      "thesis, chapter 5; del Castillo et al. 2026 (runout 50 m)"),
    event("Saint-Jude 2010"; $jude[0] | saint_jude | coarse(2; 120);
      {retrogression_m: {value: 80, sd_ln: 0.1}, runout_m: {value: 45, sd_ln: 0.2}};
      "thesis; Lacasse 2013: scar of 275 by 150 m, 54 000 m2 affected, so a mean runout of 44 to 46 m over the width"),
    event("Saint-Luc-de-Vincennes 2016"; $luc[0] | saint_luc | coarse(2; 120);
      {retrogression_m: {at_least: 40, at_most: 112}};
      "thesis, Tremblay-Auger 2021: 112 m are four events in 18 days through a neck; one of them did not go further"),
    event("Lemieux 1993"; $lemieux[0] | lemieux | coarse(3.75; 240);
      {retrogression_m: {value: 555, sd_ln: 0.05}};
      "Evans and Brooks 1994: 680 m from the river, 555 m into the plain behind an older scar")
  ],
  ensemble: {inputs: [
    {name: "slip", path: "/materials/*/softening/reference_size_m", apply: "scale", scope: "region",
     distribution: {type: "lognormal", median: 4.5, sd_ln: 0.9}},
    {name: "rate", path: "/materials/*/rate/per_decade", apply: "set", scope: "region",
     distribution: {type: "uniform", min: 0.05, max: 0.15}},
    {name: "remolded", path: "/materials/*/softening/remolded_strength_kPa", apply: "scale",
     scope: "region", distribution: {type: "uniform", min: 0.5, max: 1.2}},
    {name: "su", path: "/materials/*/peak_strength_kPa/at_elevation_m/*/1", apply: "scale",
     scope: "section", distribution: {type: "lognormal", mean: 1, cov: 0.15}},
    {name: "water", path: "/water_table/depth_m", apply: "add", scope: "section",
     distribution: {type: "triangular", min: -1, mode: 0, max: 1}}
  ]},
  discrepancy: {sd_ln: 0.3, correlation: 0.5, bias_sd_ln: 0.7},
  members: 32, locals: 6, waves: 1, least_effective_members: 16, seed: 1
}
