# Of `lowend-run --list` and of lines `VARIANT GPU RENDERER... OK|FAIL ...`: docs/low-end.md.
FNR == NR {
    gpu[++gpus] = $1
    what = $0
    sub(/^[^ ]+ +[^ ]+ +[^ ]+ +/, "", what)
    described[$1] = what
    next
}
{
    if (!($1 in seen)) {
        seen[$1] = 1
        variant[++variants] = $1
    }
    if (match($0, / OK +frag: [0-9.]+/)) {
        text = substr($0, RSTART, RLENGTH)
        sub(/.*: /, "", text)
        cell[$1, $2] = int(text + 0.5)
        passed[$2]++
        next
    }
    reason = $0
    sub(/^.* FAIL +/, "", reason)
    sub(/:? *$/, "", reason)
    gsub(/  +/, " ", reason)
    cell[$1, $2] = "FAIL"
    if (lamps($1) > 0 && (!($2 in fails_at) || lamps($1) < fails_at[$2]))
        fails_at[$2] = lamps($1)
    key = $2 SUBSEP reason
    if (!(key in count))
        why[++reasons] = key
    count[key]++
    examples[key] = examples[key] (count[key] == 1 ? "" : " ") $1
}

# The method is the first word of a variant's name.
function method(name) {
    sub(/-.*/, "", name)
    return name
}

# How many lamps a variant has, by its name; 0 where it does not say.
function lamps(name) {
    return match(name, /-[0-9]+lamps?-/) ? substr(name, RSTART + 1) + 0 : 0
}

function heading(  line, rule, g) {
    line = "| variant |"
    rule = "|---|"
    for (g = 1; g <= gpus; g++) {
        line = line " " gpu[g] " |"
        rule = rule "---:|"
    }
    print line "\n" rule
}

END {
    print "# The shader variants on old GPUs\n"
    print "Written by `scripts/low-end`: each variant compiled, linked and drawn once by Mesa's own compiler for each"
    print "GPU, without the GPU (its drivers run over a no-op drm-shim: compiles are real, pixels are not). These are"
    print "Mesa's compilers, not the vendors'. What passes has a program for both stages; GL itself reports success even"
    print "where a driver drops the draw for want of one. Variants that leave nothing out, under 1, 2, 3 and 8 lamps, with no"
    print "shadows and with as many as can be: the others have fewer instructions than one of these.\n"
    print "## The GPUs\n"
    print "| name | what it is | variants that run | the first that does not has |"
    print "|---|---|---:|---|"
    for (g = 1; g <= gpus; g++)
        printf "| %s | %s | %d of %d | %s |\n", gpu[g], described[gpu[g]], passed[gpu[g]], variants,
            gpu[g] in fails_at ? fails_at[gpu[g]] " lamps" : "-"
    print "\n## Instructions of the fragment shader\n"
    print "Static counts, a loop counted once. Units differ: compare variants on one GPU, not GPUs with each other."
    for (v = 1; v <= variants; v++) {
        name = variant[v]
        if (v == 1 || method(name) != method(variant[v - 1])) {
            print "\n### " method(name) "\n"
            heading()
        }
        line = "| " name " |"
        for (g = 1; g <= gpus; g++)
            line = line " " cell[name, gpu[g]] " |"
        print line
    }
    print "\n## Why some fail\n"
    if (reasons == 0)
        print "None does."
    for (g = 1; g <= gpus; g++)
        for (r = 1; r <= reasons; r++) {
            split(why[r], part, SUBSEP)
            if (part[1] == gpu[g])
                printf "- **%s**, %d: %s. %s\n", gpu[g], count[why[r]], part[2], shown(examples[why[r]])
        }
}

# Up to three names, then how many more.
function shown(names,  part, n) {
    n = split(names, part, " ")
    if (n <= 3)
        return names
    return part[1] " ... " part[n]
}
