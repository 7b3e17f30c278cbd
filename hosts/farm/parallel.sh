#!/bin/sh
# A folder in parts, as many at once as there are processors, with GNU parallel:
#
#   hosts/farm/parallel.sh 16 report.json library -o built --cache ~/.cache/foredraw
#
# 16: how many parts; then the report of the whole, and the words of foredraw optimize. A part that is killed is run
# again, twice at most. The environment says the rest: FOREDRAW names the program where it is not in PATH, JOBS how many
# parts run at once, and PARALLEL holds options of GNU parallel. Machines that see the same folders, over ssh:
#
#   PARALLEL='--sshlogin one,two --workdir .' hosts/farm/parallel.sh 64 report.json library -o built
set -eu

count=$1 report=$2
shift 2
parts=$report.parts
mkdir -p "$parts"
rm -f "$parts"/*.json

# 2: files failed, which would fail again. Where the report is there, it tells of them, and the part is done.
one_part='"$0" optimize "$@" --threads 1 || { code=$?; [ $code -eq 2 ] && [ -e "$report" ] || exit $code; }'

seq "$count" | parallel --will-cite --quote --jobs "${JOBS:-100%}" --retries 3 --halt soon,fail=1 --joblog "$parts/log" \
  env "report=$parts/{}.json" sh -c "$one_part" "${FOREDRAW:-foredraw}" "$@" \
  --shard "{}/$count" --report "$parts/{}.json"

"${FOREDRAW:-foredraw}" join-reports "$parts"/*.json -o "$report"
