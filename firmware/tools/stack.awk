# stack.awk - the deepest path through the calls, from gcc's -fcallgraph-info=su files (*.ci) of one image.
#
#     awk -f stack.awk FILE.ci...
#
# Prints "BYTES PATH". Calls through pointers are not in those files: each is taken to reach the deepest function whose
# address some table or argument holds and that nobody calls by name (sinks, sources, hooks), at most once on a path and
# nested INDIRECT (4) deep: a kernel's ink goes through cut, path and pen. Interrupts add their own path.
/^node:/ {
    match($0, /title: "[^"]*"/); name = substr($0, RSTART + 8, RLENGTH - 9)
    if (match($0, /[0-9]+ bytes/)) size[name] = substr($0, RSTART, RLENGTH - 6) + 0
    next
}
/^edge:/ {
    match($0, /sourcename: "[^"]*"/); from = substr($0, RSTART + 13, RLENGTH - 14)
    match($0, /targetname: "[^"]*"/); to = substr($0, RSTART + 13, RLENGTH - 14)
    if (to == "__indirect_call") indirect[from] = 1
    else { calls[from] = calls[from] SUBSEP to; called[to] = 1 }
}
function depth(f, left,    key, n, part, i, d, best, way, g) {
    key = f SUBSEP left
    if (key in done) return done[key]
    if (busy[f]) { recursive[f] = 1; return 0 }
    busy[f] = 1
    n = split(substr(calls[f], 2), part, SUBSEP)
    best = 0; way = ""
    for (i = 1; i <= n; i++) {
        d = depth(part[i], left)
        if (d > best) { best = d; way = path[part[i] SUBSEP left] }
    }
    if (indirect[f] && left > 0)
        for (g in target) {
            d = depth(g, left - 1)
            if (d > best) { best = d; way = path[g SUBSEP (left - 1)] }
        }
    busy[f] = 0
    short = f; sub(/.*:/, "", short)
    path[key] = short "(" (size[f] + 0) ")" (way == "" ? "" : " " way)
    return done[key] = best + size[f]
}
END {
    levels = INDIRECT == "" ? 4 : INDIRECT
    for (f in size) if (!(f in called) && f != "main" && f != "start_reset" && f !~ /_isr$|unexpected|console_input_isr/) target[f] = 1
    d = depth("main", levels)
    isr = 0
    for (f in size) if (f ~ /^port_.*_isr$/ && depth(f, 0) > isr) isr = depth(f, 0)
    print d + 2 * (isr + 32), path["main" SUBSEP levels]
}
