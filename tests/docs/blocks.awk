# SPDX-License-Identifier: GPL-3.0-or-later
# Takes the fenced blocks of a Markdown file apart: those that are run go to
# FOLDER/NUMBER, what they print to FOLDER/NUMBER.expected.  On standard output
# a line for each: number, language, name or -, line, the last heading's word.
/^#/ && !inside { heading = $2; sub(/:$/, "", heading); last = 0 }
/^```/ && inside { inside = 0; if (file) close(file); next }
/^```/ {
    inside = 1
    file = ""
    language = $1
    sub(/^```/, "", language)
    if (language == "knit" || language == "sh") {
        last = ++n
        file = folder "/" n
        print n, language, (NF > 1 ? $2 : "-"), NR, heading
        printf "" > file
    } else if (language == "text") {
        if (!last) {
            print "line " NR ": nothing prints this text" > "/dev/stderr"
            failed = 1
        }
        file = folder "/" last ".expected"
        printf "" > file
        last = 0
    }
    next
}
inside && file { print > file }
END { exit failed || inside }
