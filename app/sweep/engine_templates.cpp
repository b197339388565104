#include "app/sweep/engine_templates.h"

#include <array>

namespace wuerfel {

namespace {

constexpr std::string_view slurm = R"(#!/bin/bash
# Runs a sweep as an array of jobs:  sbatch sweep.sbatch PLAN
# As many shards as the array has tasks; a task that runs out of time, is preempted or loses its node goes on where it was.
#SBATCH --job-name=wuerfel-sweep
#SBATCH --array=0-63
#SBATCH --cpus-per-task=4
#SBATCH --time=4:00:00
#SBATCH --signal=B:TERM@120
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=%x-%A_%a.log

plan=${1:?usage: sbatch sweep.sbatch PLAN}
# Ends by itself, with exit code 75, ten minutes before the time is over.
"${WUERFEL:-wuerfel}" sweep run "$plan" --jobs "${SLURM_CPUS_PER_TASK:-1}" --time-budget "${TIME_BUDGET:-3h50m}" &
program=$!
trap 'kill -TERM $program' TERM USR1
wait $program
code=$?
while kill -0 $program 2>/dev/null; do  # the trap cut the waiting short
  wait $program
  code=$?
done
if [ $code -eq 75 ] || [ $code -gt 128 ]; then
  scontrol requeue "${SLURM_ARRAY_JOB_ID}_${SLURM_ARRAY_TASK_ID}"
fi
exit $code
)";

constexpr std::string_view parallel = R"(#!/bin/bash
# Runs a sweep with GNU parallel:  sweep.sh PLAN [SHARDS]
# Called again it does what is left. With --sshlogin, or a file of hosts, on several machines that share the folder.
plan=${1:?usage: sweep.sh PLAN [SHARDS]}
shards=${2:-$(nproc)}
seq 0 $((shards - 1)) |
  parallel --halt never --retries 3 "${WUERFEL:-wuerfel}" sweep run "$plan" --shard {}/"$shards" --jobs 1
)";

constexpr std::string_view make = R"(# Runs a sweep with make:  make -j 8 -f sweep.mk PLAN=PLAN
PLAN ?= plan
SHARDS ?= 64
WUERFEL ?= wuerfel
DATASET ?= $(PLAN).dataset
shards := $(addprefix shard-,$(shell seq 0 $$(($(SHARDS) - 1))))

$(DATASET): $(shards)
	$(WUERFEL) sweep merge $(PLAN) -o $@

.PHONY: $(shards)
$(shards): shard-%:
	$(WUERFEL) sweep run $(PLAN) --shard $*/$(SHARDS) --jobs 1
)";

constexpr std::string_view snakemake =
    R"(# Runs a sweep with Snakemake:  snakemake -s sweep.smk -j 8 --config plan=PLAN
plan = config["plan"]
shards = int(config.get("shards", 64))
program = config.get("wuerfel", "wuerfel")

rule dataset:
    input: expand(plan + ".done/{i}", i=range(shards))
    output: directory(plan + ".dataset")
    shell: "{program} sweep merge {plan} -o {output}"

rule shard:
    output: touch(plan + ".done/{i}")
    shell: "{program} sweep run {plan} --shard {wildcards.i}/{shards} --jobs 1"
)";

constexpr std::array templates{
    EngineTemplate{"slurm", slurm},
    EngineTemplate{"parallel", parallel},
    EngineTemplate{"make", make},
    EngineTemplate{"snakemake", snakemake},
};

}  // namespace

std::span<const EngineTemplate> engine_templates() { return templates; }

}  // namespace wuerfel
