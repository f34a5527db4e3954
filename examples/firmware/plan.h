/* This file is written by examples/print_plan ateb 3, built with -DVM_USE_FLOAT */
/* alpha = 3, accuracy 0 (0: full), float, 184 bytes */
#if VM_MANT_DIG > 24
#error "this plan is for float: define VM_USE_FLOAT"
#endif
static const ateb_plan plan = {
    {VM_C(2.62205744), VM_C(1.16395398e-07)},
    {VM_C(2.62109375), VM_C(0.000963687897), VM_C(1.16395398e-07)},
    VM_C(0.381379902), VM_C(10737.3252), VM_C(0.949999988),
    VM_C(4.0), VM_C(1.24411511), {VM_C(0.5), VM_C(0.0)},
    6, 6,
    {
    {{VM_C(-0.25), VM_C(0.0562498644), VM_C(-0.010935761), VM_C(0.00197721855),
     VM_C(-0.000327746966), VM_C(3.83787374e-05), VM_C(0.0), VM_C(0.0)},
     {VM_C(-0.25), VM_C(0.0312499702), VM_C(-0.0046871081), VM_C(0.000681696692),
     VM_C(-9.50601752e-05), VM_C(9.93015328e-06), VM_C(0.0), VM_C(0.0)}},
    {{VM_C(-0.00625000009), VM_C(3.25515575e-05), VM_C(-1.7180966e-07), VM_C(8.39404157e-10),
     VM_C(0.0), VM_C(0.0), VM_C(0.0), VM_C(0.0)},
     {VM_C(-0.03125), VM_C(0.000292968558), VM_C(-2.23774441e-06), VM_C(1.54021311e-08),
     VM_C(-8.96115335e-11), VM_C(0.0), VM_C(0.0), VM_C(0.0)}}
    }
};
