#!/usr/bin/env bash
# Turns results.csv, check.csv and ../verification/measured.csv into the rows of tables, between
# <!-- rows: GROUP --> and <!-- end of rows -->, in the READMEs of this folder, ../verification and
# solver/, so that no number is copied by hand.
#   write_tables.sh            rewrites them
#   write_tables.sh --check    changes nothing; ends with 1 where a page is not what it would write
set -euo pipefail
[[ $# -eq 0 || ($# -eq 1 && $1 == --check) ]] || { sed -n '2,6s/^# \{0,1\}//p' "$0" >&2; exit 2; }
command -v sqlite3 >/dev/null || { echo "sqlite3 is missing: apt-get install sqlite3" >&2; exit 2; }
cd "$(dirname "$0")"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# A number that is a lower bound gets ">"; a whole number loses its ".0".
{ echo $'grp\tname\tlabel\tfield\tthesis'; grep -v '^#' published.tsv; } >"$scratch/published"
{ echo $'grp\tname\tcase_name\tchange'; grep -v '^#' runs.tsv; } >"$scratch/runs"
grep -v '^#' ../data/thesis_table_0_1.csv >"$scratch/appendix"
{ echo $'title\tsource\texact\ttolerance\tprogram\ttest'; grep -v '^#' ../verification/cases.tsv; } >"$scratch/cases"
cat >"$scratch/views.sql" <<'SQL'
.mode csv
.import results.csv results
.separator "\t"
.import PATH/published published
.import PATH/runs runs
.import PATH/cases cases
.separator ","
.import PATH/appendix appendix
.import check.csv checked
.import ../verification/measured.csv measured
.mode list
CREATE VIEW shown AS SELECT runs.rowid AS place, results."group" AS grp, results.name, slides, note,
  CASE WHEN note LIKE '%backscarp reached%' THEN '>' ELSE '' END || (0 + retrogression_m) AS R,
  CASE WHEN note LIKE '%front reached%' THEN '>' ELSE '' END || (0 + runout_m) AS L,
  CASE WHEN note LIKE '%front reached%' THEN '>' ELSE '' END || (0 + runout_from_crest_m) AS Lc,
  CASE status WHEN 'at-rest' THEN printf('%.0f', simulated_s) || ' s' WHEN 'stable' THEN 'stands'
    WHEN 'time-limit' THEN 'not in ' || printf('%.0f', simulated_s) || ' s' ELSE status END AS rest,
  printf(CASE WHEN 0 + run_time_s < 9.95 THEN '%.1f' ELSE '%.0f' END, run_time_s) AS run_time,
  printf('%.1f %%', 100 * energy_error) AS energy, trigger,
  rtrim(CASE WHEN note LIKE '%backscarp reached%' THEN 'backscarp at the edge; ' ELSE '' END
    || CASE WHEN note LIKE '%front reached%' THEN 'front at the edge; ' ELSE '' END
    || CASE WHEN note LIKE '%far bank%' THEN 'far bank slid; ' ELSE '' END, '; ') AS warnings
FROM results JOIN runs ON runs.grp = results."group" AND runs.name = results.name;
CREATE VIEW found AS SELECT test, measured
  || CASE outcome WHEN 'passed' THEN '' ELSE ' (' || outcome || ')' END AS found FROM measured;
SQL
sed -i "s|PATH|$scratch|" "$scratch/views.sql"
ask() { sqlite3 -init "$scratch/views.sql" :memory: "$1" 2>&1; }

rows_of() {
  case $1 in
    landslide | blind | blind-ground) ask "SELECT '| ' || coalesce(label, shown.name) || ' | ' || coalesce(field, '') || ' | '
        || coalesce(thesis, '') || ' | ' || R || ' / ' || L || ' / ' || Lc || ' | ' || slides || ' | '
        || rest || ' | ' || run_time || ' | ' || energy || ' | ' || warnings || ' |'
      FROM shown LEFT JOIN published USING (grp, name) WHERE grp = '$1' ORDER BY place" ;;
    appendix) ask "SELECT '| ' || peak_kPa || ' / ' || remolded_kPa || ' / ' || shape_factor || ' | ' || L_R_m
        || ' | ' || R || ' | ' || L_O_m || ' | ' || Lc || ' | ' || slides || ' | ' || rest || ' |'
      FROM shown JOIN appendix
        ON name = 'toe cut 3 m, ' || peak_kPa || '/' || remolded_kPa || '/' || shape_factor
      WHERE grp = 'appendix' ORDER BY place" ;;
    machines) ask "SELECT '| ' || \"commit\" || ' | ' || date || ' | ' || machine || ' | ' || at_a_time || ' | '
        || count(*) || ' |' FROM results GROUP BY \"commit\", date, machine, at_a_time ORDER BY date, \"commit\"" ;;
    verification) ask "SELECT '| ' || title || ' | ' || source || ' | ' || exact || ' | ' || tolerance || ' | '
        || coalesce(single.found, '') || ' | ' || coalesce(double.found, '')
        || ' | ' || CASE WHEN program = '-' THEN cases.test
          ELSE '\`' || cases.test || '\`' || CASE WHEN program LIKE '%_long' THEN ' (long)' ELSE '' END END || ' |'
      FROM cases LEFT JOIN found AS single ON cases.test LIKE '%/*%' AND single.test = replace(cases.test, '/*', '/single')
        LEFT JOIN found AS double ON double.test = replace(cases.test, '/*', '/double')
      ORDER BY cases.rowid" ;;
    check) ask "SELECT '| \`' || name || '\` | ' || extreme || ' | '
        || status || CASE WHEN name LIKE 'time-step-2.5' AND status = 'unstable' THEN ', as it must' ELSE '' END || ' | '
        || CASE WHEN critical_stability_number <> '' THEN printf('gH/su %.2f', critical_stability_number)
             WHEN retrogression_m = '' THEN '-'
             ELSE printf('%.0f / %.1f', retrogression_m, runout_m) END || ' | '
        || CASE WHEN energy = '' THEN '-' ELSE printf('%.2f %%', 100 * energy) END || ' | ' || steps || ' | '
        || printf('%.1f', run_time_s) || ' | ' || CASE kept WHEN 'true' THEN 'kept' ELSE 'broken: ' || broken END || ' |'
      FROM checked ORDER BY rowid" ;;
    missing) ask "SELECT '| ' || runs.grp || ' | ' || runs.name || ' |' FROM runs LEFT JOIN results
        ON runs.grp = results.\"group\" AND runs.name = results.name
      WHERE results.name IS NULL ORDER BY runs.rowid" ;;
    *) ask "SELECT '| ' || name || ' | ' || R || ' | ' || L || ' | ' || Lc || ' | ' || slides || ' | ' || rest
        || ' | ' || trigger || CASE WHEN warnings = '' THEN '' ELSE '; ' || warnings END || ' |'
      FROM shown WHERE grp = '$1' ORDER BY place" ;;
  esac
}

# Every page is written by itself.
written() {
  local line group head rule
  while IFS= read -r line; do
    if [[ $line =~ ^'<!-- rows: '([a-z-]+)' -->'$ ]]; then
      group=${BASH_REMATCH[1]}
      # The head of the table, its first two lines, stays.
      IFS= read -r head && IFS= read -r rule
      printf '%s\n' "$line" "$head" "$rule"
      rows_of "$group"
      while IFS= read -r line && [[ $line != '<!-- end of rows -->' ]]; do :; done
      [[ $line == '<!-- end of rows -->' ]] || { echo "$1: rows of $group have no end" >&2; return 1; }
    fi
    printf '%s\n' "$line"
  done <"$1"
}

stale=0
for page in README.md ../verification/README.md ../../solver/measurements.md; do
  written "$page" >"$scratch/page"
  if [[ ${1:-} == --check ]]; then
    diff -u "$page" "$scratch/page" >&2 || stale=1
  else
    cmp -s "$scratch/page" "$page" || cp "$scratch/page" "$page"
  fi
done
((!stale)) || { echo "run tests/validation/write_tables.sh" >&2; exit 1; }
