/* Null pointers: every public function of varmass.h that takes a pointer is called with each of its pointers null in
   turn, and must refuse that. null_pointers.h has the calls. */
#include "null_pointers.h"

int main(void)
{
    call_with_null_pointers();
    return check_finish("null pointers");
}
