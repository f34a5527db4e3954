/* linked.h - is included by the compiler (-include) before a test program that shall not compile the headers' functions
   anew. Their bodies are read, but no code is made of them: the program calls those of one object, to which the headers
   are compiled once for all programs (Makefile: headers.o). A compiler without this attribute compiles all as usual. */
#ifdef __GNUC__
#define VM_API extern inline __attribute__((gnu_inline))
#endif
