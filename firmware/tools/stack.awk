# stack.awk - the deepest path through the calls of an image, read from its disassembly, so that link-time optimization and
# compiler caches do not matter. sizes.sh feeds it:
#
#     pointers.txt, addr2line -afi of all calls through pointers, readelf -r, objdump -t -s of the data, objdump -d
#
# Prints "BYTES PATH", with * before what is called through a pointer; then "! WHAT", which may be wrong, and "used WORD" for each word
# of pointers.txt that says something about this image. A frame is what a function pushes and takes from sp. On top come the
# deepest interrupts of all four levels.
#
# Calls through pointers: addr2line tells in which function of the source one stands, however that has been inlined; the first of
# those (innermost first) that has a rule in pointers.txt may call what that says, of what has its address somewhere in the image.
# A name with @ stands for all functions in that table of the image. `F without G`: below F no G is called; `G under F`: G is called
# nowhere else. Nothing calls itself, so no function is twice on a path.
function plain(f) { gsub(/\.(lto_priv|constprop|part|isra|cold)\.?[0-9]*/, "", f); return f }
function wrong(what) { told[what] = 1 }
# The words of a line or of a rule that match a name are used.
function use(words, f,    n, part, i) {
    gsub(/[\^()$]/, "", words)
    n = split(words, part, "|")
    for (i = 1; i <= n; i++) if (f ~ "^(" part[i] ")$") used[part[i]] = 1
}
function add_table(from, size, what,    a, n) {
    what = plain(what)
    sub(/\.[0-9]+$/, "", what)
    n = hex(size)
    a = hex(from)
    for (i = 0; i < n; i += 4) in_table[a + i] = what
}
# The line of a function whose address is `odd`.
function line_of(f, odd,    k, n, part, i, m, tables, t) {
    m = split(of_table[odd], tables, " ")
    for (k = 1; k <= ranks; k++) {
        n = split(rank[k], part, "|")
        for (i = 1; i <= n; i++) {
            if (part[i] !~ /^@/ && f ~ "^(" part[i] ")$") { used[part[i]] = 1; return k }
            for (t = 1; t <= m; t++) if (part[i] == "@" tables[t]) { used[part[i]] = 1; return k }
        }
    }
    wrong("in which line of pointers.txt is " f "? Its address is taken")
    return 0
}
# The rule of a call through a pointer at `site` in f.
function rule_of(f, site,    n, part, i, k) {
    n = split(chain[site], part, " ")
    part[n + 1] = f
    for (i = 1; i <= n + 1; i++)
        for (k = 1; k <= rules; k++) if (part[i] ~ caller[k]) { use(caller[k], part[i]); return k }
    wrong("what does " (n ? part[1] : f) "() call through a pointer, in " f "? There is no rule in pointers.txt")
    return 0
}
function hex(s,    i, n) { n = 0; s = tolower(s); for (i = 1; i <= length(s); i++) n = n * 16 + index("0123456789abcdef", substr(s, i, 1)) - 1; return n }
function registers(list,    n, part, i, sum, ends) { # of {r4, r5, lr} or {r4-r7}
    sub(/.*\{/, "", list); sub(/\}.*/, "", list)
    n = split(list, part, /, */)
    for (i = 1; i <= n; i++) sum += split(part[i], ends, "-") == 2 ? substr(ends[2], 2) - substr(ends[1], 2) + 1 : 1
    return sum
}
/^#/ { next }
/^[a-z]+  +[a-z_|.*@A-Z]+$/ { rank[++ranks] = $2; line[$1] = ranks; next }
/^[^ ]+ without / { out_of[++outs] = "^(" $1 ")$"; kept_out[outs] = "^(" $3 ")$"; next }
/^[^ ]+ under / { kept_in[++ins] = "^(" $1 ")$"; in_to[ins] = "^(" $3 ")$"; next }
/^[^ ]+ -> / {
    caller[++rules] = "^(" $1 ")$"
    for (i = 3; i <= NF; i++) says[rules] = says[rules] " " $i
    next
}
# addr2line: an address, and for each function that it is in, innermost first, its name and its place.
/^0x[0-9a-f]+$/ { site = substr($0, 3); sub(/^0+/, "", site); place = 0; next }
site != "" && /^[^ ]+$/ && !place { chain[site] = chain[site] " " $1; place = 1; next }
site != "" && place && /:([0-9?]+)( \(discriminator [0-9]+\))?$/ { place = 0; next }
# readelf: the words of the image that are addresses.
/^Relocation section/ { site = ""; of_image = /\.rel\.(text|data)/; next }
/ R_ARM_[A-Z0-9_]+ / { if (of_image && / R_ARM_ABS32 /) is_address[hex($1)] = 1; next }
# Data with functions' addresses in it.
/^[0-9a-f]+ .* O \.(text|data)\t/ { site = ""; split($0, col, "\t"); split(col[2], part, " "); add_table($1, part[1], part[2]); next }
/^[0-9a-f]+ .* [OF] / { site = "" }
# What is a function, by the table of symbols: data lies among them.
/^[0-9a-f]+ .* F .text\t/ { f = $1; sub(/^0+/, "", f); is_function[f] = 1; f = ""; next }
# The words of the image, as they stand in memory: an odd one may be a function's address.
/^ [0-9a-f]+ [0-9a-f]/ && NF > 1 && !/:/ {
    at_word = hex($1)
    for (i = 2; i <= 5 && length($i) == 8 && $i ~ /^[0-9a-f]+$/; i++) {
        w = substr($i, 7, 2) substr($i, 5, 2) substr($i, 3, 2) substr($i, 1, 2)
        if (at_word in is_address) word[w]++
        if (at_word in in_table) of_table[w] = of_table[w] " " in_table[at_word]
        at_word += 4
    }
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
    indirect[f] = ""
    next
}
op == ".word" { value[here] = substr(arg, 3, 8); next }
op ~ /^push/ || (op ~ /^stmdb/ && arg ~ /^sp!/) { frame[f] += 4 * registers(arg); next }
op ~ /^str/ && arg ~ /\[sp, #-[0-9]+\]!/ { n = arg; sub(/.*#-/, "", n); frame[f] += n + 0; next }
op ~ /^sub/ && arg ~ /^sp, (sp, )?#/ { n = arg; sub(/.*sp, #/, "", n); frame[f] += n + 0; next }
op ~ /^ldr/ && arg ~ /^r[0-9]+, \[pc/ { r = arg; sub(/,.*/, "", r); n = $0; sub(/.*\(/, "", n); sub(/ .*/, "", n); loaded[r] = n; next }
op ~ /^add/ && arg ~ /^sp, r/ { r = arg; sub(/.*, /, "", r); moved[f] = moved[f] " " loaded[r]; next }
op ~ /^pop/ { popped = arg; next }
op == "blx" || (op == "bx" && arg !~ /^lr/ && index(popped, arg) == 0) { gsub(/ /, "", here); indirect[f] = indirect[f] " " here; next }
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
    n = split(rules_of[g], part, " ")
    for (i = 1; i <= n; i++)
        for (t in target)
            if (target[t] >= left && ((part[i], target[t]) in may)) {
                d = depth(t, target[t] + 1, been)
                if (d > best) { best = d; way = "*" path[t] }
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
    for (k = 1; k <= rules; k++) {
        n = split(says[k], part, " ")
        for (i = 1; i <= n; i++) if (part[i] in line) may[k, line[part[i]]] = 1; else wrong("no such line: " part[i])
    }
    for (g in at) known[g] = plain(name[g])
    for (g in at) {
        last = at[g]
        odd = substr(last, 1, 7) substr("1133557799bbddff", index("0123456789abcdef", substr(last, 8)), 1)
        if (word[odd] > 0 && is_function[g] && name[g] !~ /_isr$|^console_panic$|^start_reset$|^CSWTCH/) {
            target[g] = line_of(known[g], odd)
        }
        n = split(indirect[g], part, " ")
        for (i = 1; i <= n; i++) {
            k = rule_of(known[g], part[i])
            if (index(rules_of[g] " ", " " k " ") == 0) rules_of[g] = rules_of[g] " " k
        }
        for (k = 1; k <= outs; k++) { if (known[g] ~ out_of[k]) use(out_of[k], known[g]); if (known[g] ~ kept_out[k]) use(kept_out[k], known[g]) }
        for (k = 1; k <= ins; k++) { if (known[g] ~ in_to[k]) use(in_to[k], known[g]); if (known[g] ~ kept_in[k]) use(kept_in[k], known[g]) }
        n = split(moved[g], part, " ")
        for (i = 1; i <= n; i++) if (value[part[i]] ~ /^ff/) frame[g] += 4294967296 - hex(value[part[i]])
    }
    for (g in at) if (name[g] == "start_reset") first = g
    d = depth(first, 1, "")
    d += most(0, "^(player_isr|port_timer_isr|player_dma_isr|port_switches_isr)$") + most(1, "^(port_plan_isr|ahead_plan_isr)$")
    d += most(2, "^(port_uart_isr|console_uart_isr)$") + most(3, "^(port_pen_isr|port_wake_isr|port_systick_isr)$")
    print d, path[first], "+", isr[0], isr[1], isr[2], isr[3]
    for (g in circle) wrong(g " calls itself")
    for (g in told) print "! " g
    for (g in used) print "used " g
}
