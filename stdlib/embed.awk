# SPDX-License-Identifier: GPL-3.0-or-later
# The library's .knit files in, a C table of their texts and motifs out.
function quoted(text)
{
    gsub(/\\/, "\\\\", text)
    gsub(/"/, "\\\"", text)
    gsub(/\n/, "\\n", text)
    return "\"" text "\""
}
function base(path)
{
    sub(/.*\//, "", path)
    return "std/" path
}
BEGIN {
    nfiles = nnames = 0
    print "/* Made from stdlib/ by embed.awk. */"
    print "#include <stddef.h>"
    print "#include \"lang/library.h\""
}
FNR == 1 {
    if (nfiles)
        print "    NULL,\n};"
    printf "static const char *const text%d[] = {\n", nfiles
    file[nfiles++] = base(FILENAME)
    about = ""
}
{ print "    " quoted($0) "," }
# The comment above a motif says what it is in its first line, then what other
# names it goes by; a name that begins with _ is the file's own business.
/^#/ {
    sub(/^# */, "")
    about = about == "" ? $0 : about "\n" $0
    next
}
/^motif / {
    head = $0
    sub(/^motif +/, "", head)
    name[nnames] = head
    sub(/[^A-Za-z0-9_].*/, "", name[nnames])
    if (name[nnames] ~ /^_/) {
        about = ""
        next
    }
    arguments[nnames] = ""
    if (match(head, /^[A-Za-z0-9_]+ *\([^)]*\)/)) {
        arguments[nnames] = substr(head, RSTART, RLENGTH)
        sub(/^[^(]*/, "", arguments[nnames])
    }
    described[nnames] = about
    of[nnames++] = nfiles - 1
}
{ about = "" }
END {
    print "    NULL,\n};"
    print "const struct library_file library_files[] = {"
    for (i = 0; i < nfiles; i++)
        printf "    {%s, text%d},\n", quoted(file[i]), i
    print "};"
    printf "const int library_nfiles = %d;\n", nfiles
    print "const struct library_name library_names[] = {"
    for (i = 0; i < nnames; i++)
        printf "    {%s, %s, %s, %d},\n", quoted(name[i]), quoted(arguments[i]), quoted(described[i]), of[i]
    print "};"
    printf "const int library_nnames = %d;\n", nnames
}
