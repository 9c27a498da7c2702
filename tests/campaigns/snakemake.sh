#!/usr/bin/env bash
# campaigns/Snakefile on this machine: killed in the middle it goes on, and gives the bytes of one process.
#
#   tests/campaigns/snakemake.sh FORMICARIUM SNAKEMAKE
set -euo pipefail

program="$(realpath "$1")"
snakemake="$(realpath -s "$2")"
here="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder"

question="$here/experiments/fire.toml"
options="--seeds 2"
# shellcheck disable=SC2086
"$program" compare "$question" $options --out whole >/dev/null 2>&1

campaign=("$snakemake" --snakefile "$here/campaigns/Snakefile" --profile "$here/campaigns/profiles/local" --cores 2
  --config "question=$question" "options=$options" "formicarium=$program" out=campaign shards=12 recheck=2%)

# All that it has started dies with it, as on a machine whose power fails.
setsid "${campaign[@]}" >killed.log 2>&1 &
killed=$!
for ((i = 0; i < 300; i++)); do
  [[ "$(find campaign/shards -name '*.journal' 2>/dev/null | wc -l)" -ge 2 ]] && break
  sleep 0.1
done
kill -KILL -- "-$killed" 2>/dev/null || true
wait "$killed" 2>/dev/null || true
before="$(find campaign/shards -name '*.journal' -printf '%f %T@\n' | sort)"

"${campaign[@]}" --unlock >/dev/null 2>&1
"${campaign[@]}" >campaign.log 2>&1 || {
  tail -n 40 campaign.log >&2
  exit 1
}
diff -r whole campaign/results
grep -q "the same bit for bit" campaign/recheck/*.txt
# What was whole before was not done again.
while read -r name time; do
  [[ "$(find campaign/shards -name "$name" -printf '%T@')" == "$time" ]] || {
    echo "$name was done again" >&2
    exit 1
  }
done <<<"$before"
echo "snakemake: killed after $(wc -l <<<"$before") of 12 shards, it gives the bytes of one process"

# Another question in the same folder begins anew, and what is no setting is refused.
options="--seeds 1"
# shellcheck disable=SC2086
"$program" compare "$question" $options --out fewer >/dev/null 2>&1
"${campaign[@]/options=*/options=$options}" >fewer.log 2>&1 || {
  tail -n 40 fewer.log >&2
  exit 1
}
diff -r fewer campaign/results
if "${campaign[@]}" shard=3 >wrong.log 2>&1 || ! grep -q "knows no shard" wrong.log; then
  echo "a setting that there is not is taken" >&2
  exit 1
fi
echo "snakemake: another question begins anew"
