#!/usr/bin/env bash
# A family of motions as a job array of Slurm:
#
#     slurm.sh FILE FAMILY PARTS FOLDER
#
# submits one job for each part, and one that joins them when all are done. FOLDER is one that all nodes see, as is FILE.
# `rederive` is the program of that name, or what REDERIVE says. A job whose node dies is queued again; one that finds its part
# whole does nothing, so that the same line can be given again after anything that went wrong.
#
# Slurm limits the size of an array (`scontrol show config | grep MaxArraySize`): with more parts, let each job do several.
set -euo pipefail
[ $# -eq 4 ] || { echo "usage: $0 FILE FAMILY PARTS FOLDER" >&2; exit 2; }
file=$1 family=$2 parts=$3 folder=$4 program=${REDERIVE:-rederive}
mkdir -p "$folder"
quoted() { printf '%q ' "$@"; }

part="$(quoted "$program" sweep "$file" --family "$family" --jobs 1 --resume)"
part+="--part \$SLURM_ARRAY_TASK_ID/$parts --output $(printf %q "$folder")/part-\$SLURM_ARRAY_TASK_ID.jsonl"
array=$(sbatch --parsable --requeue --array="1-$parts" --cpus-per-task=1 --output=/dev/null --error="$folder/%a.log" \
    --wrap "exec $part")
# Whatever became of the parts: if one is missing, this says which.
joined=$(sbatch --parsable --dependency="afterany:$array" --output=/dev/null --error="$folder/merge.log" \
    --wrap "exec $(quoted "$program" merge "$file" "$folder" --format json --output "$folder/merged.json")")
echo "array $array, then $joined: $folder/merged.json"
