// Weakly compressible SPH of a rectangular tank that may surge, seen from the side, in one file.
//
//     small_sph TANK.json DIRECTORY SPACING_M
//     small_sph --version
//
// TANK.json is the {tank_file} of an external run of Slosh. The program writes
// DIRECTORY/elevation.csv (the surface above the still level at the first gauge) and
// DIRECTORY/cost.json (the facts of the run). The tank is at rest and the liquid feels f =
// (-X''(t), -g), where X is the displacement of the tank:
//     d rho_a/dt = rho_a sum_b V_b (v_a - v_b).grad W_ab
//                  + 2 delta h c0 sum_b V_b (rho_ba - rho0 f.r_ba/c0^2) r_ba.grad W_ab/r_ab^2
//     d v_a/dt   = f - sum_b m_b ((p_a + p_b)/(rho_a rho_b) + Pi_ab) grad W_ab
//     p = c0^2 (rho - rho0), V = m/rho, Pi_ab = -alpha h c0 v_ab.r_ab/(rho0 (r_ab^2 + 0.01 h^2))
// The density diffusion leaves out the hydrostatic part of the density (Fourtakas et al. 2019). The
// artificial viscosity Pi (Monaghan 1992) acts on particles that approach. W is Wendland's C2
// kernel. The walls are mirror images of the particles; the tank has no roof.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

// Usual numbers of weakly compressible SPH; the smoothing length is in spacings.
constexpr double smoothing_length_ratio = 2, alpha = 0.01, delta = 0.1, courant_number = 0.25;
constexpr double pi = 3.14159265358979323846;

struct Particle {
  double x, z, u, w, rho, m;
  double a_x = 0, a_z = 0, density_rate = 0;
};

// Two particles within the kernel's support: r_ab, and grad W_ab = gradient * r_ab.
struct Pair {
  std::size_t a, b;
  double x, z, gradient;
};

// Returns the number, or the list of numbers, at the first such key of a JSON text.
std::vector<double> numbers(const std::string& text, const std::string& key) {
  const std::size_t at = text.find('"' + key + "\":");
  if (at == text.npos) throw std::runtime_error("expected " + key + " in the tank file");
  std::vector<double> found;
  for (const char* place = text.c_str() + at + key.size() + 3;;) {
    place += std::strspn(place, " \n[,");
    char* end = nullptr;
    const double value = std::strtod(place, &end);
    if (end == place) return found;
    found.push_back(value);
    place = end;
  }
}

class Liquid {
 public:
  Liquid(const std::string& tank, double spacing) : dp(spacing) {
    const auto number = [&](const char* key) { return numbers(tank, key).at(0); };
    length = number("length_m"), depth = number("fill_depth_m"), rho0 = number("density_kg_m3");
    gravity = number("gravity_m_s2");
    h = smoothing_length_ratio * dp, reach = 2 * h, c0 = 10 * std::sqrt(gravity * depth);
    const double amplitude = number("amplitude_m"), wave_number = number("mode") * pi / length;
    const double velocity = number("initial_velocity_x_m_s");
    const long columns = std::lround(length / dp), rows = std::lround(depth / dp);
    for (long i = 0; i < columns; ++i)
      for (long j = 0; j < rows; ++j) {  // a column is stretched to the height of the initial wave
        const double x = (i + 0.5) * dp, eta = amplitude * std::cos(wave_number * x);
        const double stretch = 1 + eta / depth, z = (j + 0.5) * dp * stretch;
        const double rho = rho0 * (1 + gravity * (depth + eta - z) / (c0 * c0));
        particles.push_back({x, z, velocity, 0, rho, rho * dp * dp * stretch});
      }
    count = particles.size();
  }

  // One step of leapfrog, in which the velocities are half a step behind the positions.
  void advance(double dt, double force) {
    force_x = force;
    add_mirrors();
    find_pairs();
    accelerate(dt);
    add_mirrors();  // with the new velocities
    change_densities(dt);
    for (std::size_t i = 0; i < count; ++i) {
      particles[i].x += dt * particles[i].u;
      particles[i].z += dt * particles[i].w;
    }
    exclude_lost();
  }

  // The surface above the still level: where, from above, the sum of V W first reaches a half.
  double elevation(double x) {
    add_mirrors();
    double top = 0;
    for (const Particle& p : particles) top = std::max(top, p.z);
    const double step = dp / 20;
    double above = 0;
    for (double z = top + reach; z > 0; z -= step) {
      double sum = 0;
      for (const Particle& p : particles) sum += p.m / p.rho * kernel(std::hypot(p.x - x, p.z - z));
      if (sum >= 0.5) return z + step * (sum - 0.5) / (sum - above) - depth;
      above = sum;
    }
    return std::nan("");
  }

  double dp, h, c0, length, depth, rho0, gravity;
  std::size_t count;  // of the particles of the liquid, which stand before their images
  std::size_t images() const { return particles.size() - count; }

 private:
  double kernel(double r) const {
    const double t = std::max(0.0, 1 - r / reach);
    return 7 / (4 * pi * h * h) * t * t * t * t * (1 + 2 * r / h);
  }

  // An image has the pressure that the force f leaves between it and its particle.
  void add_image(std::size_t i, bool beside, bool below) {
    Particle image = particles[i];
    if (beside) image.x = (image.x < length / 2 ? 0 : 2 * length) - image.x, image.u = -image.u;
    if (below) image.z = -image.z, image.w = -image.w;
    const double push = force_x * (image.x - particles[i].x) - gravity * (image.z - particles[i].z);
    image.rho += rho0 * push / (c0 * c0);
    particles.push_back(image);
  }

  void add_mirrors() {
    particles.resize(count, {});
    for (std::size_t i = 0; i < count; ++i) {
      const bool beside = particles[i].x < reach || particles[i].x > length - reach;
      const bool below = particles[i].z < reach;
      if (beside) add_image(i, true, false);
      if (below) add_image(i, false, true);
      if (beside && below) add_image(i, true, true);
    }
  }

  // The pairs of which one at least is of the liquid, each once, by cells as wide as the support.
  void find_pairs() {
    double top = 0;
    for (const Particle& p : particles) top = std::max(top, p.z);
    const auto cell_of = [&](double place) { return std::size_t(place / reach + 2); };
    const std::size_t columns = cell_of(length) + 3, rows = cell_of(top) + 3;
    const std::size_t none = particles.size();
    std::vector<std::size_t> first(columns * rows, none), next(particles.size());
    for (std::size_t i = 0; i < particles.size(); ++i) {
      std::size_t& head = first[cell_of(particles[i].z) * columns + cell_of(particles[i].x)];
      next[i] = head, head = i;
    }
    pairs.clear();
    for (std::size_t a = 0; a < count; ++a) {
      const std::size_t row = cell_of(particles[a].z), column = cell_of(particles[a].x);
      for (std::size_t k = row - 1; k <= row + 1; ++k)
        for (std::size_t i = column - 1; i <= column + 1; ++i)
          for (std::size_t b = first[k * columns + i]; b != none; b = next[b]) {
            if (b <= a) continue;
            const double x = particles[a].x - particles[b].x, z = particles[a].z - particles[b].z;
            const double r2 = x * x + z * z;
            if (r2 >= reach * reach) continue;
            const double t = 1 - std::sqrt(r2) / reach;
            pairs.push_back({a, b, x, z, -35 / (4 * pi * h * h * h * h) * t * t * t});
          }
    }
  }

  void accelerate(double dt) {
    for (Particle& p : particles) p.a_x = force_x, p.a_z = -gravity;
    for (const Pair& pair : pairs) {
      Particle &a = particles[pair.a], &b = particles[pair.b];
      const double pressures = c0 * c0 * (a.rho + b.rho - 2 * rho0) / (a.rho * b.rho);
      const double approach = std::min(0.0, (a.u - b.u) * pair.x + (a.w - b.w) * pair.z);
      const double r2 = pair.x * pair.x + pair.z * pair.z;
      const double viscosity = -alpha * h * c0 * approach / (rho0 * (r2 + 0.01 * h * h));
      const double force = (pressures + viscosity) * pair.gradient;
      a.a_x -= b.m * force * pair.x, a.a_z -= b.m * force * pair.z;
      b.a_x += a.m * force * pair.x, b.a_z += a.m * force * pair.z;
    }
    for (std::size_t i = 0; i < count; ++i) {
      particles[i].u += dt * particles[i].a_x;
      particles[i].w += dt * particles[i].a_z;
    }
  }

  void change_densities(double dt) {
    for (Particle& p : particles) p.density_rate = 0;
    for (const Pair& pair : pairs) {
      Particle &a = particles[pair.a], &b = particles[pair.b];
      const double divergence = (a.u - b.u) * pair.x + (a.w - b.w) * pair.z;
      const double hydrostatic = rho0 * (gravity * pair.z - force_x * pair.x) / (c0 * c0);
      const double diffusion = -2 * delta * h * c0 * (b.rho - a.rho - hydrostatic);
      a.density_rate += b.m / b.rho * (a.rho * divergence + diffusion) * pair.gradient;
      b.density_rate += a.m / a.rho * (b.rho * divergence - diffusion) * pair.gradient;
    }
    for (std::size_t i = 0; i < count; ++i) particles[i].rho += dt * particles[i].density_rate;
  }

  // A particle that has left the tank, or whose place is NaN, is taken out, as other codes do.
  void exclude_lost() {
    const auto lost = [&](const Particle& p) {
      return !(p.x > 0 && p.x < length && p.z > 0 && p.z < 100 * depth);
    };
    const auto end = particles.begin() + count;
    const auto kept = std::remove_if(particles.begin(), end, lost);
    if (kept != end) std::cout << "particles excluded: " << end - kept << '\n';
    count = kept - particles.begin();
  }

  double reach, force_x = 0;
  std::vector<Particle> particles;
  std::vector<Pair> pairs;
};

int run(const std::string& file, const std::string& directory, double spacing) {
  std::ifstream stream(file);
  const std::string tank{std::istreambuf_iterator<char>(stream), {}};
  Liquid liquid(tank, spacing);
  const std::vector<double> accelerations = numbers(tank, "acceleration_x_m_s2");
  const double table_step = numbers(tank, "time_s").at(1), gauge = numbers(tank, "x_m").at(0);
  const double interval = numbers(tank, "sample_interval_s").at(0);
  const long samples = std::lround(numbers(tank, "duration_s").at(0) / interval);
  const long steps = std::ceil(interval * liquid.c0 / (courant_number * liquid.h));
  const double dt = interval / steps;  // a sample is a whole number of steps

  std::ofstream table(directory + "/elevation.csv");
  table << "t [s],eta [m]\n0," << liquid.elevation(gauge) << '\n';
  const std::size_t particles = liquid.count, images = liquid.images();
  const auto start = std::chrono::steady_clock::now();
  for (long sample = 0; sample < samples; ++sample) {
    for (long step = 0; step < steps; ++step) {
      const double place = (sample * interval + step * dt) / table_step;
      const auto i = std::min(std::size_t(place), accelerations.size() - 2);
      const double share = place - i;
      liquid.advance(dt, -(1 - share) * accelerations[i] - share * accelerations[i + 1]);
    }
    table << (sample + 1) * interval << ',' << liquid.elevation(gauge) << '\n';
  }
  const std::chrono::duration<double> loop = std::chrono::steady_clock::now() - start;
  std::ofstream(directory + "/cost.json")
      << "{\"schema_version\": 1, \"liquid_particles\": " << particles
      << ", \"wall_particles\": " << images << ", \"steps\": " << samples * steps
      << ", \"speed_of_sound_m_s\": " << liquid.c0
      << ", \"smoothing_length_ratio\": " << smoothing_length_ratio
      << ", \"loop_wall_time_s\": " << loop.count() << "}\n";
  return table.flush() ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) try {
  if (count == 2 && arguments[1] == std::string("--version")) {
    std::cout << "small_sph 1.0\n";
    return 0;
  }
  if (count != 4) throw std::runtime_error("expected TANK.json DIRECTORY SPACING_M");
  const double spacing = std::strtod(arguments[3], nullptr);
  if (!(spacing > 0)) throw std::runtime_error("expected a spacing above 0, in m");
  return run(arguments[1], arguments[2], spacing);
} catch (const std::exception& error) {
  std::cerr << "small_sph: " << error.what() << '\n';
  return 1;
}
