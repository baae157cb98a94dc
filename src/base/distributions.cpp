#include "base/distributions.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace repose {
namespace {

namespace policies = boost::math::policies;

using Quiet = policies::policy<
    policies::promote_double<false>,  // long double would be no better here, and a second copy of all to compile
    policies::domain_error<policies::ignore_error>, policies::pole_error<policies::ignore_error>,
    policies::overflow_error<policies::ignore_error>, policies::evaluation_error<policies::ignore_error>>;
using ChiSquared = boost::math::chi_squared_distribution<double, Quiet>;
using Normal = boost::math::normal_distribution<double, Quiet>;
using Student = boost::math::students_t_distribution<double, Quiet>;

}  // namespace

double chi_squared_below(double x, double freedom) { return x > 0.0 ? cdf(ChiSquared(freedom), x) : 0.0; }
double chi_squared_quantile(double share, double freedom) { return quantile(ChiSquared(freedom), share); }
double normal_below(double x) { return cdf(Normal(), x); }
double normal_quantile(double share) { return quantile(Normal(), share); }
double student_cdf(double t, double freedom) { return cdf(Student(freedom), t); }
double student_quantile(double p, double freedom) { return quantile(Student(freedom), p); }

}  // namespace repose
