#include "solver/statics/stiffness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace leda::solver {

namespace {

constexpr std::size_t nodes = 9, axes = 2;

// Slopes of the nine splines at a point, column by column, 1/m; `f` is the distance from the
// lowest node in cells (0.5 to 1.5).
struct Slopes {
  std::array<double, nodes> x, z;
};

Slopes slopes_at(double fx, double fz, double h) {
  const auto weight = [](double f) {
    const double a = 1.5 - f, b = f - 1, c = f - 0.5;
    return std::array<double, 3>{0.5 * a * a, 0.75 - b * b, 0.5 * c * c};
  };
  const auto slope = [h](double f) {
    return std::array<double, 3>{(f - 1.5) / h, -2 * (f - 1) / h, (f - 0.5) / h};
  };
  const auto wx = weight(fx), wz = weight(fz), sx = slope(fx), sz = slope(fz);
  Slopes s{};
  for (std::size_t n = 0; n < nodes; ++n) {
    s.x[n] = sx[n / 3] * wz[n % 3];
    s.z[n] = wx[n / 3] * sz[n % 3];
  }
  return s;
}

// Stiffness among the nodes of one span; of the pairs of nodes only the lower half is kept.
class SpanStiffness {
 public:
  // volume per metre, m2; moduli in Pa
  void add(const Slopes& s, double volume, double shear, double bulk) {
    add(s, volume * (bulk - 2.0 / 3.0 * shear), volume * shear);
  }

  // The same with the dilation left to its mean over the span: what stays is the in-plane shear,
  // and add_mean_dilation() brings the rest once all particles of the span are known.
  void add_averaged(const Slopes& s, double volume, double shear, double bulk) {
    add(s, -volume * shear, volume * shear);
    for (std::size_t n = 0; n < nodes; ++n) {
      dilation_[n * axes] += volume * s.x[n];
      dilation_[n * axes + 1] += volume * s.z[n];
    }
    volume_ += volume;
    modulus_ += volume * (bulk + shear / 3);
  }

  void add_mean_dilation() {
    const double scale = modulus_ / (volume_ * volume_);
    for (std::size_t a = 0; a < nodes; ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        for (std::size_t i = 0; i < axes * axes; ++i) {
          k_[(a * nodes + b) * axes * axes + i] +=
              scale * dilation_[a * axes + i / axes] * dilation_[b * axes + i % axes];
        }
      }
    }
  }

  void add_to(ColumnMatrix& matrix, const std::array<Freedom, nodes * axes>& at) const {
    for (std::size_t i = 0; i < nodes * axes; ++i) {
      if (at[i].number < 0) continue;
      for (std::size_t j = 0; j < nodes * axes; ++j) {
        if (at[j].number < 0 || at[j].number > at[i].number) continue;
        matrix.add(at[i].number, at[j].number, at[i].sign * at[j].sign * entry(i, j));
      }
    }
  }

 private:
  void add(const Slopes& s, double lame, double g) {
    const double direct = lame + 2 * g;
    for (std::size_t a = 0; a < nodes; ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        double* k = &k_[(a * nodes + b) * axes * axes];
        k[0] += direct * s.x[a] * s.x[b] + g * s.z[a] * s.z[b];
        k[1] += lame * s.x[a] * s.z[b] + g * s.z[a] * s.x[b];
        k[2] += lame * s.z[a] * s.x[b] + g * s.x[a] * s.z[b];
        k[3] += direct * s.z[a] * s.z[b] + g * s.x[a] * s.x[b];
      }
    }
  }

  double entry(std::size_t i, std::size_t j) const {
    const std::size_t a = i / axes, b = j / axes;
    if (b <= a) return k_[(a * nodes + b) * axes * axes + i % axes * axes + j % axes];
    return k_[(b * nodes + a) * axes * axes + j % axes * axes + i % axes];
  }

  std::array<double, nodes * nodes * axes * axes> k_{};
  std::array<double, nodes * axes> dilation_{};  // sum V grad w, m
  double volume_ = 0, modulus_ = 0;              // sums of V and of V (lame + G)
};

void fill(SpanStiffness& span, double h, double volume, double shear, double bulk) {
  const double apart = 0.5 / std::sqrt(3.0);  // Gauss points, 2 x 2
  for (const double fx : {1 - apart, 1 + apart}) {
    for (const double fz : {1 - apart, 1 + apart}) {
      span.add(slopes_at(fx, fz, h), volume / 4, shear, bulk);
    }
  }
}

// A point by the row of its home cell.
struct PointInRow {
  std::uint32_t row;
  std::size_t pack, lane;
};

// The points of a column from the lowest row up.
std::vector<PointInRow> points_of(const Packs<double>& packs, std::uint32_t column) {
  std::vector<PointInRow> points;
  const PackGroup& group = packs.group[column / columns_of_a_group];
  for (std::size_t i = group.first; i < group.end(); ++i) {
    if (packs.place[i].column != column) continue;
    for (std::size_t l = 0; l < Pack<double>::lanes; ++l) {
      if ((packs.taken[i] >> l & 1U) == 0) continue;
      points.push_back(
          {packs.place[i].row + static_cast<std::uint32_t>(l % Pack<double>::rows), i, l});
    }
  }
  std::ranges::stable_sort(points, {}, &PointInRow::row);
  return points;
}

// Stiffness of the points of one span, `first` to `last` - 1.
SpanStiffness span_of(const Model<double>& model, const LawTable& laws,
                      std::span<const PointInRow> points, double filling) {
  const Packs<double>& packs = model.packs;
  const double h = model.grid.h;
  const bool averages = model.grid.averages();
  SpanStiffness span;
  const auto law_of = [&](const PointInRow& at) {
    return static_cast<std::size_t>(packs.pack[at.pack].law[at.lane]);
  };
  const std::size_t first = law_of(points.front());
  fill(span, h, filling * h * h, laws.shear[first], laws.bulk[first]);
  for (const PointInRow& at : points) {
    const Pack<double>& p = packs.pack[at.pack];
    const std::size_t law = law_of(at);
    const Slopes slopes = slopes_at(p.x[at.lane] + 0.5, p.z[at.lane] + 0.5, h);
    if (averages) {
      span.add_averaged(slopes, p.volume[at.lane], laws.shear[law], laws.bulk[law]);
    } else {
      span.add(slopes, p.volume[at.lane], laws.shear[law], laws.bulk[law]);
    }
  }
  if (averages) span.add_mean_dilation();
  return span;
}

}  // namespace

ColumnMatrix elastic_stiffness(const Model<double>& model, const LawTable& laws,
                               const Freedoms& freedoms, double filling) {
  ColumnMatrix matrix(freedoms);
  for (std::uint32_t c = 0; c < model.grid.columns; ++c) {
    const std::vector<PointInRow> points = points_of(model.packs, c);
    for (std::size_t i = 0, next = 0; i < points.size(); i = next) {
      const std::uint32_t row = points[i].row;
      while (next < points.size() && points[next].row == row) ++next;
      std::array<Freedom, nodes * axes> at;
      for (std::size_t n = 0; n < nodes * axes; ++n) {
        const std::size_t node = n / axes;
        at[n] = freedoms.at(c + node / 3, row + node % 3)[n % axes];
      }
      span_of(model, laws, std::span(points).subspan(i, next - i), filling).add_to(matrix, at);
    }
  }
  return matrix;
}

}  // namespace leda::solver
