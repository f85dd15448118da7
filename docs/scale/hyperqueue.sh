#!/usr/bin/env bash
# A family of motions on HyperQueue, as `slurm.sh` does it on Slurm:
#
#     hyperqueue.sh FILE FAMILY PARTS FOLDER
#
# NOT RUN BY THIS PROJECT'S TESTS: the package of HyperQueue that they can have brings no `hq`. A server and workers are up
# (`hq server start`, `hq worker start`); a task whose worker is lost is begun again by the server.
set -euo pipefail
[ $# -eq 4 ] || { echo "usage: $0 FILE FAMILY PARTS FOLDER" >&2; exit 2; }
file=$1 family=$2 parts=$3 folder=$4 program=${REDERIVE:-rederive}
mkdir -p "$folder"
export file family parts folder program

# shellcheck disable=SC2016 # what is in the quotes is for the shell of the task
hq submit --wait --array "1-$parts" --cpus 1 --stdout none --stderr "$folder/%{TASK_ID}.log" \
    --env file="$file" --env family="$family" --env parts="$parts" --env folder="$folder" --env program="$program" -- \
    bash -c 'exec "$program" sweep "$file" --family "$family" --part "$HQ_TASK_ID/$parts" --jobs 1 --resume \
        --output "$folder/part-$HQ_TASK_ID.jsonl"'
"$program" merge "$file" "$folder" --format json --output "$folder/merged.json"
echo "$folder/merged.json"
