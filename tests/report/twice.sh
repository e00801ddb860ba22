#!/bin/sh
# twice.sh A B - are two directories that report.sh wrote the same, times aside? Times are what differs from run to run: files
# that end in -times.tsv, plots over time, and in the texts the columns and sentences of them.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT INT TERM
bad=0
without_times() {
    awk -F '|' '
        # A header: which columns are times. `with` belongs to the one before it.
        /^[|]/ && !table {
            table = 1
            for (i = 2; i < NF; i++) {
                if ($i ~ /^ *with *$/) skip[i] = skip[i - 1]
                else skip[i] = $i ~ /(^| )(ns|us|ms) per |\(us\)|^ *ms *$|[tT]ime|, now|^ *random \/ smooth/
            }
        }
        /^[|]/ { line = ""; for (i = 2; i < NF; i++) if (!skip[i]) line = line "|" $i; print line; next }
        { table = 0 }
        /[tT]imes?[ :,.(]|R\^2|^On this machine/ { next }
        { print }' "$1" || echo "awk failed on $1" $$
}
for f in $(cd "$1" && ls; cd "$OLDPWD" && cd "$2" && ls); do echo "$f"; done | sort -u >"$work/files"
while read -r f; do
    case $f in
    *-times.tsv | pareto.svg | sizes.svg | simplify.svg | figure11.svg | growth.svg) continue ;;
    *.md)
        without_times "$1/$f" >"$work/a"
        without_times "$2/$f" >"$work/b"
        diff "$work/a" "$work/b" >"$work/diff" && continue
        ;;
    *) cmp "$1/$f" "$2/$f" >"$work/diff" 2>&1 && continue ;;
    esac
    echo "FAILED: $f differs between two runs of the same commit"
    head -5 "$work/diff"
    bad=$((bad + 1))
done <"$work/files"
[ $bad -eq 0 ] && echo "$(wc -l <"$work/files") files: the same numbers twice, times aside"
exit $bad
