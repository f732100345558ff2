// Boost.Math's cn with a C interface: with its default policy, which computes in the next wider type, and without. Errors come back as NaN: an exception must not reach Rust.
#include <boost/math/policies/policy.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/version.hpp>

namespace {
using namespace boost::math::policies;
using Quiet = policy<domain_error<ignore_error>, overflow_error<ignore_error>, evaluation_error<ignore_error>>;
using Plain = policy<domain_error<ignore_error>, overflow_error<ignore_error>, evaluation_error<ignore_error>,
                     promote_double<false>, promote_float<false>>;
}

extern "C" {
double pendula_boost_cn(double k, double u) { return boost::math::jacobi_cn(k, u, Quiet()); }
double pendula_boost_plain_cn(double k, double u) { return boost::math::jacobi_cn(k, u, Plain()); }
float pendula_boost_cnf(float k, float u) { return boost::math::jacobi_cn(k, u, Quiet()); }
float pendula_boost_plain_cnf(float k, float u) { return boost::math::jacobi_cn(k, u, Plain()); }
unsigned pendula_boost_version() { return BOOST_VERSION; }
}
