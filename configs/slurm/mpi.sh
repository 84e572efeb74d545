#!/bin/bash
# SPDX-License-Identifier: MIT
# The same under what starts N processes with numbers: mpirun, mpiexec, srun. The processes do not
# speak with each other.
#   mpirun -n 8 configs/slurm/mpi.sh CONFIG RESULTS
#   srun -n 8 configs/slurm/mpi.sh CONFIG RESULTS
set -euo pipefail
rank=${OMPI_COMM_WORLD_RANK:-${PMI_RANK:-${PMIX_RANK:-${SLURM_PROCID:-}}}}
size=${OMPI_COMM_WORLD_SIZE:-${PMI_SIZE:-${SLURM_NTASKS:-}}}
if [[ -z $rank || -z $size ]]; then
  echo "mpi.sh: no rank and size in the environment; start it with mpirun, mpiexec or srun" >&2
  exit 2
fi
exec "${BULLETNAV:-./bulletnav}" run "${1:?give the config of a run}" \
  --out "${2:?give the folder of results}" --no-plots --shard "$((rank + 1))/$size"
