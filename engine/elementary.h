#pragma once

/// Elementary functions that give the same bits on every machine, compiler and optimisation level: built from IEEE
/// additions, multiplications, divisions and square roots only, never from the C library, whose last bits differ
/// between versions and processors. Within 1 ulp of the exact value over the whole range unless said otherwise;
/// special values (NaN, infinities, signed zeros) as in C99 annex F.

namespace proofreel::elementary {

double sin(double x);
double cos(double x);
double tan(double x);
double asin(double x);
double acos(double x);
double atan(double x);
double atan2(double y, double x);
double exp(double x);
double log(double x);
double log2(double x);
double log10(double x);
double pow(double x, double y);

}  // namespace proofreel::elementary
