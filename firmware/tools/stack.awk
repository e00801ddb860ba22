# stack.awk - the deepest path through the calls of an image, read from its disassembly, so that link-time optimization and
# compiler caches do not matter.
#
#     { cat pointers.txt; objdump -t -s -j .text -j .data IMAGE; objdump -d --no-show-raw-insn IMAGE; } | awk -f stack.awk
#
# Prints "BYTES PATH", with * before what is called through a pointer. A frame is what a function pushes and takes from sp. A
# call through a pointer reaches what pointers.txt says, of what has its address somewhere in the image; `F without G` says that
# below F no G is called, `G under F` that G is called nowhere else. Who is not in there is listed on stderr, and then the bound may be too low. Nothing calls itself, so no function is twice on a path. On top
# come the deepest interrupts of all four levels.
function plain(f) { gsub(/\.(lto_priv|constprop|part|isra|cold)\.?[0-9]*/, "", f); return f }
function hex(s,    i, n) { n = 0; s = tolower(s); for (i = 1; i <= length(s); i++) n = n * 16 + index("0123456789abcdef", substr(s, i, 1)) - 1; return n }
function registers(list,    n, part, i, sum, ends) { # of {r4, r5, lr} or {r4-r7}
    sub(/.*\{/, "", list); sub(/\}.*/, "", list)
    n = split(list, part, /, */)
    for (i = 1; i <= n; i++) sum += split(part[i], ends, "-") == 2 ? substr(ends[2], 2) - substr(ends[1], 2) + 1 : 1
    return sum
}
/^[a-z]+  +[a-z_|.*]+$/ { rank[++ranks] = "^(" $2 ")$"; line[$1] = ranks; next }
/^[^ ]+ without / { out_of[++outs] = "^(" $1 ")$"; kept_out[outs] = "^(" $3 ")$"; next }
/^[^ ]+ under / { kept_in[++ins] = "^(" $1 ")$"; in_to[ins] = "^(" $3 ")$"; next }
/^[^ ]+ -> / { caller[++rules] = "^(" $1 ")$"; for (i = 3; i <= NF; i++) may[rules, line[$i]] = 1; next }
# What is a function, by the table of symbols: data lies among them.
/^[0-9a-f]+ .* F .text\t/ { f = $1; sub(/^0+/, "", f); is_function[f] = 1; f = ""; next }
# The words of the image, as they stand in memory: an odd one may be a function's address.
/^ [0-9a-f]+ [0-9a-f]/ && NF > 1 && !/:/ {
    for (i = 2; i <= 5 && length($i) == 8 && $i ~ /^[0-9a-f]+$/; i++)
        word[substr($i, 7, 2) substr($i, 5, 2) substr($i, 3, 2) substr($i, 1, 2)]++
    next
}
# A function is known by where it is: several may have one name.
/^[0-9a-f]+ <.*>:$/ {
    f = $1; sub(/^0+/, "", f)
    name[f] = $2; gsub(/[<>:]/, "", name[f])
    at[f] = substr($1, length($1) - 7)
    popped = ""
    split("", loaded)
    next
}
f == "" || !/^ *[0-9a-f]+:\t/ { next }
{
    split($0, col, "\t")
    op = col[2]; arg = col[3]
    here = $1; sub(/:/, "", here)
}
# A veneer holds the address of what it calls.
op == ".word" && name[f] ~ /_veneer$/ {
    to = substr(arg, 3, 8)
    word[to]--
    to = substr(to, 1, 7) substr("0022446688aaccee", index("0123456789abcdef", substr(to, 8)), 1); sub(/^0+/, "", to)
    calls[f] = calls[f] " " to
    indirect[f] = 0
    next
}
op == ".word" { value[here] = substr(arg, 3, 8); next }
op ~ /^push/ || (op ~ /^stmdb/ && arg ~ /^sp!/) { frame[f] += 4 * registers(arg); next }
op ~ /^str/ && arg ~ /\[sp, #-[0-9]+\]!/ { n = arg; sub(/.*#-/, "", n); frame[f] += n + 0; next }
op ~ /^sub/ && arg ~ /^sp, (sp, )?#/ { n = arg; sub(/.*sp, #/, "", n); frame[f] += n + 0; next }
op ~ /^ldr/ && arg ~ /^r[0-9]+, \[pc/ { r = arg; sub(/,.*/, "", r); n = $0; sub(/.*\(/, "", n); sub(/ .*/, "", n); loaded[r] = n; next }
op ~ /^add/ && arg ~ /^sp, r/ { r = arg; sub(/.*, /, "", r); moved[f] = moved[f] " " loaded[r]; next }
op ~ /^pop/ { popped = arg; next }
op == "blx" { indirect[f] = 1; next }
op == "bx" && arg !~ /^lr/ && index(popped, arg) == 0 { indirect[f] = 1; next }
op ~ /^b/ && arg ~ /<[^+]*>/ {
    to = arg; sub(/ .*/, "", to)
    if (to != f && !((f, to) in edge)) { edge[f, to] = 1; calls[f] = calls[f] " " to }
}
# Is g not called on a way that has been through `way`?
function barred(g, way,    k) {
    for (k = 1; k <= outs; k++) if (index(way, "o" k " ") && known[g] ~ kept_out[k]) return 1
    for (k = 1; k <= ins; k++) if (!index(way, "i" k " ") && known[g] ~ kept_in[k]) return 1
    return 0
}
function depth(g, left, been,    key, n, part, i, d, best, way, t, k) {
    if (barred(g, been)) return 0
    if (busy[g]) { circle[known[g]] = 1; return 0 }
    for (k = 1; k <= outs; k++) if (known[g] ~ out_of[k] && !index(been, "o" k " ")) been = been "o" k " "
    for (k = 1; k <= ins; k++) if (known[g] ~ in_to[k] && !index(been, "i" k " ")) been = been "i" k " "
    key = g SUBSEP left SUBSEP been
    if (key in done) { path[g] = ways[key]; return done[key] }
    busy[g] = 1
    n = split(calls[g], part, " ")
    best = 0; way = ""
    for (i = 1; i <= n; i++) {
        d = depth(part[i], left, been)
        if (d > best) { best = d; way = path[part[i]] }
    }
    if (indirect[g]) {
        for (k = 1; k <= rules && known[g] !~ caller[k]; k++) continue
        if (k > rules) untold[known[g]] = 1
        for (t in target)
            if (target[t] >= left && ((k, target[t]) in may)) {
                d = depth(t, target[t] + 1, been)
                if (d > best) { best = d; way = "*" path[t] }
            }
    }
    busy[g] = 0
    path[g] = ways[key] = name[g] "(" (frame[g] + 0) ")" (way == "" ? "" : " " way)
    return done[key] = best + frame[g]
}
function most(level, names,    g, d, best) {
    best = 0
    for (g in at) if (name[g] ~ names) { d = depth(g, ranks + 1, "") + 36; if (d > best) { best = d; isr[level] = name[g] } } # 8 words, and one to align
    return best
}
END {
    for (g in at) known[g] = plain(name[g])
    for (g in at) {
        last = at[g]
        odd = substr(last, 1, 7) substr("1133557799bbddff", index("0123456789abcdef", substr(last, 8)), 1)
        if (word[odd] > 0 && is_function[g] && name[g] !~ /_isr$|^console_panic$|^start_reset$|^CSWTCH/) {
            for (k = 1; k <= ranks && known[g] !~ rank[k]; k++) continue
            if (k > ranks) unknown = unknown " " known[g]
            target[g] = k
        }
        n = split(moved[g], part, " ")
        for (i = 1; i <= n; i++) if (value[part[i]] ~ /^ff/) frame[g] += 4294967296 - hex(value[part[i]])
    }
    for (g in at) if (name[g] == "start_reset") first = g
    d = depth(first, 1, "")
    d += most(0, "^(player_isr|port_timer_isr|player_dma_isr|port_switches_isr)$") + most(1, "^(port_plan_isr|ahead_plan_isr)$")
    d += most(2, "^(port_uart_isr|console_uart_isr)$") + most(3, "^(port_pen_isr|port_wake_isr|port_systick_isr)$")
    for (g in circle) around = around " " g
    if (around) print "calls itself:" around > "/dev/stderr"
    for (g in untold) unknown = unknown " " g "()"
    if (unknown) print "not in pointers.txt:" unknown > "/dev/stderr"
    print d, path[first], "+", isr[0], isr[1], isr[2], isr[3]
}
