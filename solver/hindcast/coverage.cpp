#include "solver/hindcast/coverage.hpp"

#include <boost/math/distributions/binomial.hpp>

namespace leda::solver {

Coverage coverage(std::size_t hits, std::size_t of, double confidence) {
  Coverage c{hits, of};
  if (of == 0) return c;
  const boost::math::binomial_distribution<> right(static_cast<double>(of), confidence);
  c.chance = boost::math::cdf(right, static_cast<double>(hits));
  return c;
}

}  // namespace leda::solver
