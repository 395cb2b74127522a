# SPDX-License-Identifier: GPL-3.0-or-later
# The tables of the language taken apart: a script for each case, FOLDER/0001.knit .., and
# what it is about and comes to, in WANTED. -v folder=FOLDER/ -v wanted=WANTED.
function begin(expected) {
    close(file)
    file = sprintf("%s%04d.knit", folder, ++n)
    print about "|" expected >wanted
}
FNR == 1   { each = file = "" }
/^@@ /     { about = substr($0, 4); file = ""; next }
/^@each /  { each = substr($0, 7); line = "Row 1: k2, %s, k2\n"; next }
/^@after / { each = substr($0, 8); line = "Cast on 4\nRow 1: knit\n%s\n"; next }
/^@ /      { each = ""; begin(substr($0, 3)); next }
each != "" && NF { begin(each); printf line, $0 >file; next }
each == "" && file != "" { print >file }
