#include "core/time/events/dop853.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <Eigen/Core>

namespace wuerfel {
namespace {

/// A stage and its coefficient.
struct Term {
  int stage;
  double factor;
};

// Order of terms: stages 1 .. 12 of the method are k[0] .. k[11]; k[12] is f at the new point.
constexpr std::array<Term, 1> stage_2 = {{{0, 5.26001519587677318785587544488e-2}}};
constexpr std::array<Term, 2> stage_3 = {
    {{0, 1.97250569845378994544595329183e-2}, {1, 5.91751709536136983633785987549e-2}}};
constexpr std::array<Term, 2> stage_4 = {
    {{0, 2.95875854768068491816892993775e-2}, {2, 8.87627564304205475450678981324e-2}}};
constexpr std::array<Term, 3> stage_5 = {{{0, 2.41365134159266685502369798665e-1},
                                          {2, -8.84549479328286085344864962717e-1},
                                          {3, 9.24834003261792003115737966543e-1}}};
constexpr std::array<Term, 3> stage_6 = {{{0, 3.7037037037037037037037037037e-2},
                                          {3, 1.70828608729473871279604482173e-1},
                                          {4, 1.25467687566822425016691814123e-1}}};
constexpr std::array<Term, 4> stage_7 = {{{0, 3.7109375e-2},
                                          {3, 1.70252211019544039314978060272e-1},
                                          {4, 6.02165389804559606850219397283e-2},
                                          {5, -1.7578125e-2}}};
constexpr std::array<Term, 5> stage_8 = {{{0, 3.70920001185047927108779319836e-2},
                                          {3, 1.70383925712239993810214054705e-1},
                                          {4, 1.07262030446373284651809199168e-1},
                                          {5, -1.53194377486244017527936158236e-2},
                                          {6, 8.27378916381402288758473766002e-3}}};
constexpr std::array<Term, 6> stage_9 = {{{0, 6.24110958716075717114429577812e-1},
                                          {3, -3.36089262944694129406857109825e0},
                                          {4, -8.68219346841726006818189891453e-1},
                                          {5, 2.75920996994467083049415600797e1},
                                          {6, 2.01540675504778934086186788979e1},
                                          {7, -4.34898841810699588477366255144e1}}};
constexpr std::array<Term, 7> stage_10 = {{{0, 4.77662536438264365890433908527e-1},
                                           {3, -2.48811461997166764192642586468e0},
                                           {4, -5.90290826836842996371446475743e-1},
                                           {5, 2.12300514481811942347288949897e1},
                                           {6, 1.52792336328824235832596922938e1},
                                           {7, -3.32882109689848629194453265587e1},
                                           {8, -2.03312017085086261358222928593e-2}}};
constexpr std::array<Term, 8> stage_11 = {{{0, -9.3714243008598732571704021658e-1},
                                           {3, 5.18637242884406370830023853209e0},
                                           {4, 1.09143734899672957818500254654e0},
                                           {5, -8.14978701074692612513997267357e0},
                                           {6, -1.85200656599969598641566180701e1},
                                           {7, 2.27394870993505042818970056734e1},
                                           {8, 2.49360555267965238987089396762e0},
                                           {9, -3.0467644718982195003823669022e0}}};
constexpr std::array<Term, 9> stage_12 = {{{0, 2.27331014751653820792359768449e0},
                                           {3, -1.05344954667372501984066689879e1},
                                           {4, -2.00087205822486249909675718444e0},
                                           {5, -1.79589318631187989172765950534e1},
                                           {6, 2.79488845294199600508499808837e1},
                                           {7, -2.85899827713502369474065508674e0},
                                           {8, -8.87285693353062954433549289258e0},
                                           {9, 1.23605671757943030647266201528e1},
                                           {10, 6.43392746015763530355970484046e-1}}};
constexpr std::array<Term, 8> stage_14 = {{{0, 5.61675022830479523392909219681e-2},
                                           {6, 2.53500210216624811088794765333e-1},
                                           {7, -2.46239037470802489917441475441e-1},
                                           {8, -1.24191423263816369460010140626e-1},
                                           {9, 1.5329179827876569731206322685e-1},
                                           {10, 8.20105229563468988491666602057e-3},
                                           {11, 7.56789766054569976138603589584e-3},
                                           {12, -8.298e-3}}};
constexpr std::array<Term, 8> stage_15 = {{{0, 3.18346481635021405060768473261e-2},
                                           {5, 2.83009096723667755288322961402e-2},
                                           {6, 5.35419883074385676223797384372e-2},
                                           {7, -5.49237485713909884646569340306e-2},
                                           {10, -1.08347328697249322858509316994e-4},
                                           {11, 3.82571090835658412954920192323e-4},
                                           {12, -3.40465008687404560802977114492e-4},
                                           {13, 1.41312443674632500278074618366e-1}}};
constexpr std::array<Term, 8> stage_16 = {{{0, -4.28896301583791923408573538692e-1},
                                           {5, -4.69762141536116384314449447206e0},
                                           {6, 7.68342119606259904184240953878e0},
                                           {7, 4.06898981839711007970213554331e0},
                                           {8, 3.56727187455281109270669543021e-1},
                                           {12, -1.39902416515901462129418009734e-3},
                                           {13, 2.9475147891527723389556272149e0},
                                           {14, -9.15095847217987001081870187138e0}}};
constexpr std::array<Term, 8> eighth_order = {{{0, 5.42937341165687622380535766363e-2},
                                               {5, 4.45031289275240888144113950566},
                                               {6, 1.89151789931450038304281599044},
                                               {7, -5.8012039600105847814672114227},
                                               {8, 3.1116436695781989440891606237e-1},
                                               {9, -1.52160949662516078556178806805e-1},
                                               {10, 2.01365400804030348374776537501e-1},
                                               {11, 4.47106157277725905176885569043e-2}}};
constexpr std::array<Term, 8> error_5 = {{{0, 0.1312004499419488073250102996e-1},
                                          {5, -0.1225156446376204440720569753e1},
                                          {6, -0.4957589496572501915214079952},
                                          {7, 0.1664377182454986536961530415e1},
                                          {8, -0.3503288487499736816886487290},
                                          {9, 0.3341791187130174790297318841},
                                          {10, 0.8192320648511571246570742613e-1},
                                          {11, -0.2235530786388629525884427845e-1}}};
constexpr std::array<Term, 12> dense_4 = {{{0, -0.84289382761090128651353491142e1},
                                           {5, 0.56671495351937776962531783590},
                                           {6, -0.30689499459498916912797304727e1},
                                           {7, 0.23846676565120698287728149680e1},
                                           {8, 0.21170345824450282767155149946e1},
                                           {9, -0.87139158377797299206789907490},
                                           {10, 0.22404374302607882758541771650e1},
                                           {11, 0.63157877876946881815570249290},
                                           {12, -0.88990336451333310820698117400e-1},
                                           {13, 0.18148505520854727256656404962e2},
                                           {14, -0.91946323924783554000451984436e1},
                                           {15, -0.44360363875948939664310572000e1}}};
constexpr std::array<Term, 12> dense_5 = {{{0, 0.10427508642579134603413151009e2},
                                           {5, 0.24228349177525818288430175319e3},
                                           {6, 0.16520045171727028198505394887e3},
                                           {7, -0.37454675472269020279518312152e3},
                                           {8, -0.22113666853125306036270938578e2},
                                           {9, 0.77334326684722638389603898808e1},
                                           {10, -0.30674084731089398182061213626e2},
                                           {11, -0.93321305264302278729567221706e1},
                                           {12, 0.15697238121770843886131091075e2},
                                           {13, -0.31139403219565177677282850411e2},
                                           {14, -0.93529243588444783865713862664e1},
                                           {15, 0.35816841486394083752465898540e2}}};
constexpr std::array<Term, 12> dense_6 = {{{0, 0.19985053242002433820987653617e2},
                                           {5, -0.38703730874935176555105901742e3},
                                           {6, -0.18917813819516756882830838328e3},
                                           {7, 0.52780815920542364900561016686e3},
                                           {8, -0.11573902539959630126141871134e2},
                                           {9, 0.68812326946963000169666922661e1},
                                           {10, -0.10006050966910838403183860980e1},
                                           {11, 0.77771377980534432092869265740},
                                           {12, -0.27782057523535084065932004339e1},
                                           {13, -0.60196695231264120758267380846e2},
                                           {14, 0.84320405506677161018159903784e2},
                                           {15, 0.11992291136182789328035130030e2}}};
constexpr std::array<Term, 12> dense_7 = {{{0, -0.25693933462703749003312586129e2},
                                           {5, -0.15418974869023643374053993627e3},
                                           {6, -0.23152937917604549567536039109e3},
                                           {7, 0.35763911791061412378285349910e3},
                                           {8, 0.93405324183624310003907691704e2},
                                           {9, -0.37458323136451633156875139351e2},
                                           {10, 0.10409964950896230045147246184e3},
                                           {11, 0.29840293426660503123344363579e2},
                                           {12, -0.43533456590011143754432175058e2},
                                           {13, 0.96324553959188282948394950600e2},
                                           {14, -0.39177261675615439165231486172e2},
                                           {15, -0.14972683625798562581422125276e3}}};

// The third-order estimate: eighth_order less these.
constexpr std::array<Term, 3> third_order = {{{0, 0.244094488188976377952755905512},
                                              {8, 0.733846688281611857341361741547},
                                              {11, 0.220588235294117647058823529412e-1}}};

/// Of all evaluations but the first one and f(next).
constexpr std::array<std::span<const Term>, Dop853::evaluations> tableau = {std::span<const Term>(),
                                                                            stage_2,
                                                                            stage_3,
                                                                            stage_4,
                                                                            stage_5,
                                                                            stage_6,
                                                                            stage_7,
                                                                            stage_8,
                                                                            stage_9,
                                                                            stage_10,
                                                                            stage_11,
                                                                            stage_12,
                                                                            std::span<const Term>(),
                                                                            stage_14,
                                                                            stage_15,
                                                                            stage_16};

using Stages = std::array<std::vector<double>, Dop853::evaluations>;

double sum(std::span<const Term> terms, const Stages& k, std::size_t i) {
  double total = 0.0;
  for (const Term& term : terms)
    total += term.factor * k[term.stage][i];
  return total;
}

/// A few components that follow one another, side by side in registers: those of a cube.
constexpr int width = 6;
using Part = Eigen::Matrix<double, width, 1>;

Part sums(std::span<const Term> terms, const Stages& k, std::size_t first) {
  Part total = Part::Zero();
  for (const Term& term : terms)
    total += term.factor * Eigen::Map<const Part>(k[term.stage].data() + first);
  return total;
}

/// result := y + h sum of terms
void combine(std::span<const Term> terms,
             const Stages& k,
             const std::vector<double>& y,
             double h,
             std::vector<double>& result) {
  result.resize(y.size());
  std::size_t i = 0;
  for (; i + width <= y.size(); i += width) {
    Eigen::Map<Part>(result.data() + i) =
        Eigen::Map<const Part>(y.data() + i) + h * sums(terms, k, i);
  }
  for (; i < y.size(); ++i)
    result[i] = y[i] + h * sum(terms, k, i);
}

}  // namespace

void Dop853::begin(const std::vector<double>& rate, double h) {
  h_ = h;
  if (k_.back().size() != rate.size()) {
    for (auto& k : k_)
      k.resize(rate.size());
  }
  k_[0] = rate;
}

const std::vector<double>& Dop853::stage_state(int i, const std::vector<double>& y) {
  combine(tableau[i], k_, y, h_, y_);
  return y_;
}

constinit const std::array<double, Dop853::stages> Dop853::stage_weights = [] {
  std::array<double, stages> all{};
  for (const Term& term : eighth_order)
    all[term.stage] = term.factor;
  return all;
}();

void Dop853::end(const std::vector<double>& y) { combine(eighth_order, k_, y, h_, next_); }

double Dop853::error(const std::vector<double>& scale) const {
  double worst = 0.0;
  for (std::size_t i = 0; i < scale.size(); ++i) {
    const double fifth = sum(error_5, k_, i) / scale[i];
    const double third = (sum(eighth_order, k_, i) - sum(third_order, k_, i)) / scale[i];
    const double both = fifth * fifth + 0.01 * third * third;
    if (both > 0.0) worst = std::max(worst, fifth * fifth / std::sqrt(both));
    if (!std::isfinite(both)) return both;
  }
  return std::abs(h_) * worst;
}

void Dop853::interpolate(const std::vector<double>& y, DenseStep& result) const {
  result.coefficients.resize(y.size() * DenseStep::terms);
  double* c = result.coefficients.data();
  for (std::size_t i = 0; i < y.size(); ++i, c += DenseStep::terms) {
    const double rise = next_[i] - y[i];
    const double bend = h_ * k_[0][i] - rise;
    c[0] = y[i];
    c[1] = rise;
    c[2] = bend;
    c[3] = rise - h_ * k_[12][i] - bend;
    c[4] = h_ * sum(dense_4, k_, i);
    c[5] = h_ * sum(dense_5, k_, i);
    c[6] = h_ * sum(dense_6, k_, i);
    c[7] = h_ * sum(dense_7, k_, i);
  }
}

}  // namespace wuerfel
