// attack: has the compiler quote a file that it never read, as the place of an error
// says: does not compile
// never says: reference solution

#line 1 "../../../solutions/variance.cpp"
int 1a;
