#!/usr/bin/env bash
# campaigns/shards.sbatch and the Slurm profile of campaigns/Snakefile on a cluster of one node, which this script sets up and takes down.
# Needs Debian's slurm-wlm and root; says so and ends well where they are missing.
#
#   tests/campaigns/slurm.sh FORMICARIUM [SNAKEMAKE]
set -euo pipefail

program="$(realpath "$1")"
snakemake="${2:-}"
here="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"

skip() {
  echo "slurm: SKIPPED, $1"
  exit 0
}
for tool in slurmctld slurmd sbatch squeue; do
  command -v "$tool" >/dev/null || skip "$tool is not installed: apt-get install slurm-wlm"
done
[[ "$(id -u)" == 0 ]] || skip "one node of one's own needs root"
# Jobs find their cluster here: no other setting reaches them by every way.
[[ ! -e /etc/slurm/slurm.conf ]] || skip "this machine is part of a cluster: /etc/slurm/slurm.conf"

folder="$(mktemp -d)"
node="$(hostname -s)"
cpus="$(nproc)"
megabytes="$(awk '/MemTotal/ { print int($2 / 1100) }' /proc/meminfo)"
mkdir -p "$folder/state" "$folder/spool" /etc/slurm
cat >/etc/slurm/slurm.conf <<END
ClusterName=formicarium
SlurmctldHost=$node(127.0.0.1)
SlurmUser=root
SlurmctldPort=26817
SlurmdPort=26818
AuthType=auth/none
CredType=cred/none
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
ProctrackType=proctrack/pgid
TaskPlugin=task/none
MailProg=/bin/true
ReturnToService=2
SchedulerParameters=sched_interval=1,bf_interval=1
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
NodeName=$node NodeAddr=127.0.0.1 CPUs=$cpus RealMemory=$megabytes State=UNKNOWN
PartitionName=main Nodes=$node Default=YES MaxTime=INFINITE State=UP
END

end() {
  for daemon in slurmctld slurmd; do
    [[ -f "$folder/$daemon.pid" ]] && kill "$(cat "$folder/$daemon.pid")" 2>/dev/null || true
  done
  wait 2>/dev/null || true
  rm -rf /etc/slurm/slurm.conf "$folder"
}
trap end EXIT

fail() {
  echo "slurm: FAILED, $1" >&2
  tail -n 20 "$folder"/*.log >&2 || true
  exit 1
}
# Waits until a command succeeds, for at most so many seconds.
until_done() {
  local seconds="$1"
  shift
  for ((i = 0; i < seconds * 5; i++)); do
    "$@" && return 0
    sleep 0.2
  done
  return 1
}
is_up() { sinfo --noheader --format=%T 2>/dev/null | grep -q idle; }
is_empty() { [[ -z "$(squeue --noheader)" ]]; }

slurmctld -D >"$folder/slurmctld.log" 2>&1 &
slurmd -D >"$folder/slurmd.log" 2>&1 &
until_done 30 is_up || { tail -n 5 "$folder"/slurm*.log && skip "a cluster of one node does not come up here: see above"; }

cd "$folder"
question="$here/experiments/threshold.toml"
options="--seeds 2 --only $("$program" compare "$question" --document | sed -n 's/.*"instances":\[{"id":"\([^"]*\)".*/\1/p' | head -n 1)"
# shellcheck disable=SC2086
"$program" compare "$question" $options --out whole >/dev/null 2>&1

begun="$SECONDS"
QUESTION="$question" OUT="$folder/array" OPTIONS="$options" FORMICARIUM="$program" \
  sbatch --array=1-6 --output="$folder/%A_%a.log" "$here/campaigns/shards.sbatch" >/dev/null
until_done 120 is_empty || fail "the array does not end"
took="$((SECONDS - begun))"
# shellcheck disable=SC2086
"$program" compare "$question" $options --merge array/shards --out array/results --recheck 2% >/dev/null 2>merge.log \
  || fail "the array's journals do not merge"
diff -r whole array/results || fail "the array's results are not those of one process"
echo "slurm: an array of 6 shards, done after $took s, gives the bytes of one process"

# A part of an array does not take itself for the whole.
rm array/shards/*.shard-5of6.journal
part() {
  QUESTION="$question" OUT="$folder/array" OPTIONS="$options" FORMICARIUM="$program" SHARDS="$1" \
    sbatch --wait --array=5 --output="$folder/%A_%a.log" "$here/campaigns/shards.sbatch" >/dev/null
}
! part "" || fail "a part of an array takes itself for the whole"
part 6 || fail "shard 5 of 6 is not done again"
ls array/shards/*.shard-5of6.journal >/dev/null || fail "shard 5 of 6 is not done again"

if [[ -n "$snakemake" ]]; then
  # Slurm's own plugin reads the states of jobs from its accounting, which one node does not have: from the controller then.
  "$snakemake" --snakefile "$here/campaigns/Snakefile" --profile "$here/campaigns/profiles/slurm" --directory "$folder/work" \
    --slurm-status-command squeue --slurm-init-seconds-before-status-checks 1 --seconds-between-status-checks 1 --latency-wait 5 \
    --default-resources slurm_partition=main slurm_account=none \
    --config "question=$question" "options=$options" "formicarium=$program" "out=$folder/jobs" shards=4 \
    >snakemake.log 2>&1 || fail "Snakemake's jobs do not end"
  diff -r whole jobs/results || fail "the results of Snakemake's jobs are not those of one process"
  echo "slurm: Snakemake's jobs of 4 shards give the bytes of one process"
fi
