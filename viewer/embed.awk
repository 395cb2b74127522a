# SPDX-License-Identifier: GPL-3.0-or-later
# A text in, a C table of its lines out.
BEGIN {
    print "/* Made from viewer/template.html by embed.awk. */"
    print "#include <stddef.h>"
    print "extern const char *const page_template[];"
    print "const char *const page_template[] = {"
}
{
    gsub(/[\\"?]/, "\\\\&")
    print "    \"" $0 "\","
}
END { print "    NULL,\n};" }
