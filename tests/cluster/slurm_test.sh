#!/bin/bash
# SPDX-License-Identifier: MIT
# A run as a job array on a Slurm of two nodes, each in a network namespace of this machine; one task
# is requeued in mid-run. The merged episodes must be those of one process, byte for byte.
#   sudo tests/cluster/slurm_test.sh [PROGRAM]
# Needs root and Debian's slurmctld, slurmd, slurm-client, munge, iproute2; not among the ordinary
# tests. Changes nothing but what it makes: namespaces bn1 and bn2, a bridge bnbr, a folder.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
program=$(realpath "${1:-$root/build/release/bulletnav}")
[[ $EUID -eq 0 ]] || { echo "slurm_test.sh: needs root for network namespaces" >&2; exit 2; }
for tool in slurmctld slurmd sbatch munged ip; do
  command -v "$tool" >/dev/null || { echo "slurm_test.sh: $tool is missing" >&2; exit 2; }
done

work=$(mktemp -d)
chmod 755 "$work"
stop() {
  local status=$?
  [[ $status -eq 0 ]] || tail -n 5 "$work"/*.log >&2 || true
  kill $(cat "$work"/*.pid 2>/dev/null) 2>/dev/null || true
  sleep 1
  for node in bn1 bn2; do ip netns del "$node" 2>/dev/null || true; done
  ip link del bnbr 2>/dev/null || true
  rm -rf "$work"
  exit "$status"
}
trap stop EXIT

start_network() {
  ip link add bnbr type bridge
  ip addr add 10.77.0.1/24 dev bnbr
  ip link set bnbr up
  for i in 1 2; do
    ip netns add "bn$i"
    ip link add "bnveth$i" type veth peer name eth0 netns "bn$i"
    ip link set "bnveth$i" master bnbr up
    ip -n "bn$i" addr add "10.77.0.1$i/24" dev eth0
    ip -n "bn$i" link set eth0 up
    ip -n "bn$i" link set lo up
  done
}

write_config() {
  cat >"$work/slurm.conf" <<CONF
ClusterName=bulletnav
SlurmctldHost=$(hostname -s)(10.77.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge.socket
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool-%n
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd-%n.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=2
MpiDefault=none
ReturnToService=2
RequeueExit=75
NodeName=bn1 NodeAddr=10.77.0.11 CPUs=1 State=UNKNOWN
NodeName=bn2 NodeAddr=10.77.0.12 CPUs=1 State=UNKNOWN
PartitionName=all Nodes=bn1,bn2 Default=YES MaxTime=INFINITE State=UP
CONF
}

start_slurm() {
  mkdir -p "$work/state" "$work/spool-bn1" "$work/spool-bn2"
  dd if=/dev/urandom of="$work/munge.key" bs=1024 count=1 status=none
  chmod 600 "$work/munge.key"
  munged --force --socket "$work/munge.socket" --key-file "$work/munge.key" \
    --pid-file "$work/munged.pid" --log-file "$work/munged.log" --seed-file "$work/munged.seed"
  export SLURM_CONF=$work/slurm.conf
  slurmctld
  for node in bn1 bn2; do
    # Not `ip netns exec`, which hides the control groups that slurmd looks for.
    nsenter --net="/run/netns/$node" unshare --uts bash -c "hostname $node; exec slurmd -N $node"
  done
  for _ in $(seq 60); do
    [[ $(sinfo --noheader --states=idle --format=%D 2>/dev/null) == 2 ]] && return
    sleep 0.5
  done
  sinfo >&2
  echo "slurm_test.sh: the nodes do not come up" >&2
  exit 1
}

wait_for() {
  while [[ -n $(squeue --noheader --jobs="$1" 2>/dev/null) ]]; do sleep 1; done
}

cat >"$work/run.yaml" <<CONF
houses: {folder: $work/houses, count: 1, first_seed: 3}
episodes:
  file: $work/episodes.json
  draw: {houses: {index: $work/houses/index.json, split: train}, counts: {easy: 8, medium: 4}, seed: 1}
backend: embree
settings: [rgbd]
agents: [{agent: nts}, {agent: metric_map_fbe}]
CONF

start_network
write_config
start_slurm
cd "$work"
export BULLETNAV=$program
"$program" run run.yaml --no-plots --workers 1 --out one >one.log 2>&1
job=$(sbatch --parsable --cpus-per-task=1 --array=1-4 --output="$work/task-%a.log" \
  "$root/configs/slurm/array.sbatch" "$work/run.yaml" "$work/four")
until compgen -G "four/shards/1-of-4/episodes.jsonl" >/dev/null; do sleep 0.2; done
scontrol requeue "${job}_1" || true
merge=$(sbatch --parsable --dependency="afterok:$job" --output="$work/merge.log" \
  "$root/configs/slurm/merge.sbatch" "$work/four")
wait_for "$job"
wait_for "$merge"
grep -q "DUE TO JOB REQUEUE" task-1.log ||
  { echo "slurm_test.sh: the first task ended before it could be requeued" >&2; exit 1; }
cmp one/episodes.jsonl four/episodes.jsonl
cmp one/table.md four/table.md
echo "the array's merged results are those of one process, byte for byte"
