#!/bin/sh
# Tries every setting of settings.csv with every colony of planners.txt on the training maps, and writes runs.csv: how many of the runs found a
# path, the mean gap of those to the optimum, and the mean cost of all: a run costs its gap, and at most 1, a path twice as long as need be,
# or none. Then prints of each colony the setting that is best: of the least cost, the first of equals.
# usage: experiments/tuning/own-colony/tune.sh
# FORMICARIUM is the program, target/release/formicarium unless it says otherwise. Maps and runs go into WORK, target/tuning/own-colony.
set -e
here=$(realpath "$(dirname "$0")")
FORMICARIUM=$(realpath "${FORMICARIUM:-$here/../../../target/release/formicarium}")
WORK=$(realpath -m "${WORK:-$here/../../../target/tuning/own-colony}")
mkdir -p "$WORK"
awk -f "$here/settings.awk" > "$here/settings.csv"
cd "$WORK"

# generate NAME KIND SIZE SEED [OPTIONS]: a training map, and its lines of the question.
generate() {
    name=$1 kind=$2 size=$3 seed=$4
    shift 4
    "$FORMICARIUM" generate "$kind" --size "$size" --seed "$seed" "$@" --as scenario --out "$name.json"
    printf '[[instances]]\nid = "%s"\nmap = "%s.json"\n' "$name" "$name"
}

{
    cat << END
format = "formicarium/question@1"
title = "Settings of colonies on training maps"
asks = "Which of the same settings suits each colony best, by the same budget?"
seeds = { from = 1001, count = 1 }
budget = { axis = "moves", amount = 500000 }
END
    generate random-64 random 64x64 1001 --density 0.25
    generate random-192 random 192x192 1002 --density 0.25
    generate rooms-96 rooms 96x96 1003
    generate rooms-224 rooms 224x224 1004
    generate maze-65 maze 65x65 1005
    generate cave-128 cave 128x128 1006
    generate cave-256 cave 256x256 1007
    generate blocks-160 blocks 160x64 1008
    # What a colony has no row for is left out; IAACO's evaporation is its rho_gain.
    "$FORMICARIUM" catalog --json | jq -r '.planners[] | .id as $id | .params[] | "\($id) \(.key)"' > rows.txt
    awk -F '[, ]' '
        FILENAME == "rows.txt" { has[$1, $2] = 1; next }
        /^#/ { next }
        FILENAME ~ /planners.txt$/ { planner[++planners] = $1; for (i = 2; i <= NF; i++) { split($i, own, "="); set[$1] = own[1] " = \"" own[2] "\"" } next }
        $1 == "setting" { for (i = 2; i <= NF; i++) key[i] = $i; next }
        { setting[++settings] = $0 }
        END {
            for (p = 1; p <= planners; p++) for (s = 1; s <= settings; s++) {
                id = planner[p]; n = split(setting[s], value, ","); values = set[id]
                for (i = 2; i <= n; i++) {
                    k = key[i] == "rho" && !has[id, "rho"] ? "rho_gain" : key[i]
                    if (value[i] == "" || !has[id, k]) continue
                    values = values (values == "" ? "" : ", ") k " = " (value[i] ~ /^[a-z]/ ? "\"" value[i] "\"" : value[i])
                }
                printf "[[entries]]\nid = \"%s-%s\"\nlabel = \"%s %s\"\nrole = \"other\"\nplanner = \"%s\"\nset = { %s }\n", id, value[1], id, value[1], id, values
            }
        }' rows.txt "$here/planners.txt" "$here/settings.csv"
} > own-colony-tuning.toml
"$FORMICARIUM" compare own-colony-tuning.toml --out . --files csv --replace

# Entries are PLANNER-SETTING; columns of a run: instance, entry, seed, status, length, … and gap, the last but one.
awk -F , -v planners="$here/planners.txt" -v settings="$here/settings.csv" '
    NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
    { runs[$2]++ }
    { gap = $column["gap"] }
    gap != "" { found[$2]++; gaps[$2] += gap }
    { costs[$2] += gap == "" || gap > 1 ? 1 : gap }
    END {
        print "planner,setting,runs,found,gap,cost"
        while ((getline line < settings) > 0) { split(line, part, ","); if (part[1] != "setting") setting[++n] = part[1] }
        while ((getline line < planners) > 0) {
            if (line ~ /^#/) continue
            split(line, part, " ")
            for (s = 1; s <= n; s++) {
                id = part[1] "-" setting[s]
                gap = found[id] ? sprintf("%.6f", gaps[id] / found[id]) : ""
                printf "%s,%s,%d,%d,%s,%.6f\n", part[1], setting[s], runs[id], found[id], gap, costs[id] / runs[id]
            }
        }
    }' own-colony-tuning.csv > "$here/runs.csv"
awk -F , '
    NR > 1 && ($1 != planner || $6 + 0 < cost) {
        if ($1 != planner) order[++n] = $1
        planner = $1; cost = $6 + 0; best[$1] = $2 ", cost " $6 ", " $4 " of " $3 " runs with a path, mean gap " $5
    }
    END { for (i = 1; i <= n; i++) print order[i] ": " best[order[i]] }' "$here/runs.csv"
