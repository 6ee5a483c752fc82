#include "solver/ensemble/design.hpp"

#include <boost/random/sobol.hpp>

namespace leda::solver {
namespace {

/// Boost's engine leaves out the first point of the sequence, the origin, which spoils the net
/// (Owen 2020, arXiv:2008.08051): it is put back here.
std::vector<std::uint64_t> sobol_net(std::size_t dimensions, std::size_t points) {
  std::vector<std::uint64_t> net(dimensions, 0);
  net.reserve(dimensions * points);
  boost::random::sobol engine(dimensions);
  while (net.size() < dimensions * points) net.push_back(engine());
  return net;
}

}  // namespace

const char* to_string(Method method) {
  switch (method) {
    case Method::sobol:
      return "sobol";
    case Method::latin:
      return "latin";
    case Method::random:
      return "random";
  }
  return "";
}

std::optional<Method> method_from(const std::string& text) {
  for (const Method method : {Method::sobol, Method::latin, Method::random}) {
    if (text == to_string(method)) return method;
  }
  return std::nullopt;
}

Design::Design(const Sampling& sampling, std::size_t dimensions, std::size_t first_members,
               std::size_t most_members)
    : method_(sampling.method),
      replicates_(sampling.replicates),
      dimensions_(dimensions),
      first_points_(first_members / sampling.replicates) {
  if (method_ == Method::sobol && dimensions > 0) {
    net_ = sobol_net(dimensions, (most_members + replicates_ - 1) / replicates_);
  }
}

double Design::coordinate(std::size_t dimension, std::size_t member, const Key& key) const {
  const std::size_t replicate = member % replicates_, point = member / replicates_;
  switch (method_) {
    case Method::sobol:
      return of_net(dimension, replicate, point, key);
    case Method::latin:
      return of_latin_hypercube(replicate, point, key);
    case Method::random:
      break;
  }
  return key.with(member).uniform();
}

/// A digital shift keeps a net a net and makes each point uniform.
double Design::of_net(std::size_t dimension, std::size_t replicate, std::size_t point,
                      const Key& key) const {
  const std::uint64_t shift = key.with(replicate).bits();
  return unit_interval(net_[point * dimensions_ + dimension] ^ shift);
}

/// A hypercube cannot be extended: the points that a doubling adds are one of their own.
double Design::of_latin_hypercube(std::size_t replicate, std::size_t point, const Key& key) const {
  std::size_t begin = 0, size = first_points_;
  while (point >= begin + size) {
    begin += size;
    size = begin;
  }
  const Key of_replicate = key.with(replicate);
  const std::uint64_t own = of_replicate.with(point).bits();
  std::size_t slice = 0;
  for (std::size_t other = begin; other < begin + size; ++other) {
    if (of_replicate.with(other).bits() < own) ++slice;
  }
  const double within = of_replicate.with("within").with(point).uniform();
  return (static_cast<double>(slice) + within) / static_cast<double>(size);
}

}  // namespace leda::solver
