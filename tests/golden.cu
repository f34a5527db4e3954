/* The golden program on a graphics processor: a single thread calls the public functions of the section GOLDEN_SECTION of
   tests/golden.c, and prints its line. tests/gpu.sh runs it, a section at a time, since nvcc needs much longer for all at once. */
#define VM_API static __noinline__ __host__ __device__
#include "../varmass.h"
#include <cstdio>

/* The program itself runs on the device: its functions and its variables belong there, and main() is called by a kernel. */
#define puts(line) printf("%s\n", line)
#define static __device__ static
#define main __device__ golden_main
#include "golden.c"
#undef static
#undef main

__global__ void run(int *status) { *status = golden_main(); }

int main()
{
    const size_t stack = 1 << 17; /* bytes */
    int *status, result = 1;
    if (cudaMalloc(&status, sizeof *status) || cudaDeviceSetLimit(cudaLimitStackSize, stack)) {
        std::fputs("no GPU\n", stderr);
        return 1;
    }
    run<<<1, 1>>>(status);
    if (cudaMemcpy(&result, status, sizeof result, cudaMemcpyDeviceToHost)) {
        std::fprintf(stderr, "%s\n", cudaGetErrorString(cudaGetLastError()));
        return 1;
    }
    return result;
}
