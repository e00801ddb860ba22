#!/bin/sh
# compare.sh TOOL RIDGELINE SEED EXPRESSIONS SCRIPTS: in a folder of its own, for histories and pictures.
tool=$(realpath "$1") program=$(realpath "$2")
shift 2
folder=$(mktemp -d)
cd "$folder" || exit 1
HOME=$folder "$tool" "$program" "$@"
rc=$?
rm -rf "$folder"
exit $rc
