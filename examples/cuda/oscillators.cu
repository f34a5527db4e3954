/* A million oscillators on a GPU: x'' + x|x|^(alpha-1) = 0 with mass that leaks, alpha from 0 to 8, each thread one of
   them. The host computes the same, and both have the same bits where products and sums are not contracted.

   nvcc -O3 -fmad=false -I. examples/cuda/oscillators.cu -o oscillators && ./oscillators */
#define VM_API static inline __host__ __device__
#include "../../varmass.h"
#include <chrono>
#include <cstdio>
#include <vector>

/* Position and velocity of oscillator i of n at time t, when half of its mass has gone without reactive force */
static inline __host__ __device__ void oscillate(long i, long n, vm_real t, vm_real *x, vm_real *v)
{
    const vm_real alpha = 8 * (vm_real)i / (vm_real)n;
    const vm_real A = vm_osc_amplitude_law(VM_C(0.5), 0, 0, alpha);
    vm_osc_exact(t, A, VM_SQRT(2), alpha, x, v);
}

__global__ void sweep(long n, vm_real t, vm_real *x, vm_real *v)
{
    const long i = blockIdx.x * (long)blockDim.x + threadIdx.x;
    if (i < n) oscillate(i, n, t, x + i, v + i);
}

static double seconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int main()
{
    const long n = 1000000;
    const vm_real t = 100;
    std::vector<vm_real> x(n), v(n), host_x(n), host_v(n);
    vm_real *device_x, *device_v;
    double start, gpu = 0, cpu;
    long differing = 0;
    if (cudaMalloc(&device_x, n * sizeof(vm_real)) || cudaMalloc(&device_v, n * sizeof(vm_real))) {
        std::puts("no GPU");
        return 0;
    }
    for (int repeat = 0; repeat < 3; repeat++) {
        start = seconds();
        sweep<<<(unsigned)((n + 255) / 256), 256>>>(n, t, device_x, device_v);
        cudaDeviceSynchronize();
        gpu = seconds() - start;
    }
    if (cudaGetLastError()) {
        std::puts("the kernel failed");
        return 1;
    }
    cudaMemcpy(x.data(), device_x, n * sizeof(vm_real), cudaMemcpyDeviceToHost);
    cudaMemcpy(v.data(), device_v, n * sizeof(vm_real), cudaMemcpyDeviceToHost);
    start = seconds();
    for (long i = 0; i < n; i++) oscillate(i, n, t, &host_x[i], &host_v[i]);
    cpu = seconds() - start;
    for (long i = 0; i < n; i++) differing += x[i] != host_x[i] || v[i] != host_v[i];
    std::printf("%ld oscillators: GPU %.2f ms, one core %.0f ms, %ld with other bits\n", n, gpu * 1e3, cpu * 1e3, differing);
    return differing != 0;
}
