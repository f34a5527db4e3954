/* Bodies and the words of the library: vm_strerror. Each status has words of its own, and one that does not exist
   has those for unknown statuses. */
#include "../varmass.h"
#include "check.h"

static void test_status(void)
{
    int status, other;
    for (status = VM_TOO_MANY_EVENTS; status <= VM_TOLERANCE_MISSED; status++)
        for (other = status + 1; other <= VM_TOLERANCE_MISSED + 1; other++)
            CHECK(strcmp(vm_strerror(status), vm_strerror(other)) != 0);
    CHECK(strcmp(vm_strerror(VM_NO_LAW), vm_strerror(VM_NOT_INTEGRATED)) != 0);
    CHECK(strcmp(vm_strerror(VM_TOLERANCE_MISSED), vm_strerror(77)) != 0);
    CHECK(strcmp(vm_strerror(VM_DOMAIN), vm_strerror(-99)) != 0);
}

int main(void)
{
    test_status();
    return check_finish("bodies");
}
