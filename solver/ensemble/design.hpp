#pragma once
// Where members stand in the unit cube: Sobol's nets, Latin hypercubes or chance. Members are
// dealt to the replicates in turn (member m is point m / replicates of replicate m % replicates),
// so that doubling their number doubles every replicate, and nets stay whole.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solver/section/key.hpp"

namespace leda::solver {

enum class Method { sobol, latin, random };

const char* to_string(Method method);  ///< "sobol", "latin", "random"
std::optional<Method> method_from(const std::string& text);

struct Sampling {
  Method method = Method::sobol;
  std::uint64_t seed = 1;
  std::size_t replicates = 8;  ///< independent of each other; 1 with Method::random
};

/// Immutable, safe for several threads.
class Design {
 public:
  /// @param first_members how many members stand at the first look; a multiple of the replicates
  /// @param most_members at most so many are asked for
  Design(const Sampling& sampling, std::size_t dimensions, std::size_t first_members,
         std::size_t most_members);

  /// One coordinate of a member, within (0, 1). Under the same key the coordinates of all members
  /// make one design; other keys give designs that are independent of it.
  double coordinate(std::size_t dimension, std::size_t member, const Key& key) const;

 private:
  double of_net(std::size_t dimension, std::size_t replicate, std::size_t point,
                const Key& key) const;
  double of_latin_hypercube(std::size_t replicate, std::size_t point, const Key& key) const;

  Method method_;
  std::size_t replicates_, dimensions_, first_points_;
  std::vector<std::uint64_t> net_;  ///< coordinates of a point side by side
};

}  // namespace leda::solver
