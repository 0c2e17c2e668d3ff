// SPDX-License-Identifier: 0BSD
// One step of double or float rows: whole groups by vector instructions, what is left over row by row.
#include "step_groups.hpp"
#include "twoscale/kernels/refine.hpp"

namespace twoscale::kernels::detail {

template <class Real>
void VectorStep<Real>::operator()(const Rows<Real>& rows) const {
  const long m = arity_;
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(rows.in_stride);
  Real* out = rows.out;
  const auto single = [&](long i) {
    const long q = floor_div(i, m);
    const std::size_t r = static_cast<std::size_t>(i - m * q);
    const Real* in = rows.in + (q - rows.in_first) * stride;
    for (std::size_t c = 0; c < rows.width; ++c) {
      out[c] = sum_of_phase(phases_.phase[r], phases_.weight.data(), [&](std::size_t s) {
        return in[phases_.offset[s] * stride + static_cast<std::ptrdiff_t>(c)];
      });
    }
    out += rows.out_stride;
  };
  const long end = rows.out_first + static_cast<long>(rows.count);
  const long q_first = ceil_div(rows.out_first, m);
  const long q_end = std::max(q_first, floor_div(end, m));
  long i = rows.out_first;
  for (; i < std::min(end, m * q_first); ++i) single(i);
  if (q_end > q_first) {
    const std::size_t groups = static_cast<std::size_t>(q_end - q_first);
    run_groups({phases_.weight.data(), phases_.offset.data(), phases_.phase.data(), static_cast<std::size_t>(m), groups,
                rows.width, rows.in + (q_first - rows.in_first) * stride, rows.in_stride, out, rows.out_stride});
    out += groups * static_cast<std::size_t>(m) * rows.out_stride;
    i = m * q_end;
  }
  for (; i < end; ++i) single(i);
}

template <class Real>
void VectorStep<Real>::side_by_side(const Real* in, std::size_t groups, std::size_t width, Real* out) const {
  run_side_by_side({phases_.weight.data(), phases_.offset.data(), phases_.phase.data(),
                    static_cast<std::size_t>(arity_), groups, width, in, out, nullptr, false});
}

template <class Real>
void VectorStep<Real>::apart(const Real* in, std::size_t groups, std::size_t width, Real* const* out,
                             bool stream) const {
  run_side_by_side({phases_.weight.data(), phases_.offset.data(), phases_.phase.data(),
                    static_cast<std::size_t>(arity_), groups, width, in, nullptr, out, stream});
}

template <class Real>
std::size_t VectorStep<Real>::pairs_between() const {
  const Phases<Real>& p = phases_;
  if (arity_ != 2 || !p.phase[0].copies || p.offset[p.phase[0].begin] != 0) return 0;
  const Phase& odd = p.phase[1];
  const auto n = static_cast<std::ptrdiff_t>(odd.pairs);
  const bool consecutive =
      n > 0 && odd.end - odd.begin == 2 * odd.pairs && p.offset[odd.begin] == 1 - n && p.offset[odd.end - 1] == n;
  return consecutive && has_three_steps(odd.pairs) ? odd.pairs : 0;
}

template <class Real>
void VectorStep<Real>::three_apart(const VectorStep& second, const VectorStep& third, const Real* in,
                                   std::size_t groups, std::size_t width, Real* const* out, bool stream) const {
  const auto weight = [](const VectorStep& step) { return step.phases_.weight.data() + step.phases_.phase[1].begin; };
  run_three_steps({weight(*this), weight(second), weight(third), pairs_between(), groups, width, in, out, stream});
}

template <class Real>
void VectorStep<Real>::three_wide(const VectorStep& second, const VectorStep& third, const Real* in,
                                  std::size_t in_stride, std::size_t groups, std::size_t width, Real* out,
                                  std::size_t out_stride, bool stream) const {
  const auto weight = [](const VectorStep& step) { return step.phases_.weight.data() + step.phases_.phase[1].begin; };
  run_three_wide_steps({weight(*this), weight(second), weight(third), pairs_between(), groups, width, in, in_stride,
                        out, out_stride, stream});
}

template <>
std::size_t segments_of<double>(int arity, std::size_t width) {
  return arity <= 3 ? best_segments(sizeof(double), width) : 0;
}
template <>
std::size_t segments_of<float>(int arity, std::size_t width) {
  return arity <= 3 ? best_segments(sizeof(float), width) : 0;
}

template class VectorStep<double>;
template class VectorStep<float>;

}  // namespace twoscale::kernels::detail
