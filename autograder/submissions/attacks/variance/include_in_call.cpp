// attack: makes a file the argument of a macro, which turns it into a message
// says: /etc/passwd
// never says: root:

#define TEXT(...) #__VA_ARGS__
#define SAY(text) _Pragma(TEXT(GCC error text))
#define SHOW(...) SAY(TEXT(__VA_ARGS__))
#define QUOTE(...) SHOW(__VA_ARGS__)
QUOTE(
#include "/etc/passwd"
)
