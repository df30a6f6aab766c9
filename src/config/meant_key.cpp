// SPDX-License-Identifier: BSD-3-Clause
#include "src/config/meant_key.hpp"

#include <fmt/format.h>

#include <string_view>

#include "src/config/keys.hpp"
#include "src/config/nearest_word.hpp"

namespace bagnold {

namespace {

/// Words in small letters and digits, between blanks, with the key that they stand for.
struct Elsewhere {
  std::string_view words;
  std::string_view key;       ///< "" where there is none
  std::string_view why = "";  ///< the key does not exist
};

/// Names of quantities and settings of a scene in papers, in LAMMPS and in other programs.
constexpr Elsewhere keys_elsewhere[] = {
    {"dt timestep deltat stepsize tstep h", "integration.time_step"},
    {"n number particles nparticles numparticles numberofparticles particlenumber particlecount "
     "natoms "
     "atoms ndisks numdisks ndiscs discs grains ngrains",
     "disks.count"},
    {"phi volumefraction areafraction solidfraction density packing vf solids",
     "disks.packing_fraction"},
    {"gammadot gdot dotgamma shearrate rate erate edot epsilondot", "shear.strain_rate"},
    {"gamma totalstrain maxstrain strainmax finalstrain shearstrain", "shear.strain"},
    {"gamma0 strainamplitude amp", "shear.amplitude"},
    {"piecespercycle windowspercycle stepspercycle pointspercycle", "shear.cycle_pieces"},
    {"ncycles numcycles numberofcycles oscillations periods nperiods", "shear.cycles"},
    {"omega frequency freq angularfrequency", "",
     "an oscillation has its period T = 2 pi/omega, shear.period, or shear.peak_rate = amplitude "
     "omega"},
    {"q quality qualityfactor", "disks.elasticity"},
    {"equilibration equilibrate equilsteps burnin warmup transient", "shear.discard"},
    {"law contactlaw contactmodel forcelaw interaction forcemodel pairstyle", "disks.model"},
    {"randomseed rng rngseed", "disks.seed"},
    {"runs repeats realizations realisations ensemble nreplicas", "disks.replicas"},
    {"integrator method algorithm", "integration.scheme"},
    {"cutoff rcut neighbor neighbour verletskin", "integration.skin"},
    {"dump dumpevery trajectory traj snapshots saveevery snapshotevery",
     "output.trajectory_strain"},
    {"thermo log logevery sampleevery outputevery", "output.sample_strain"},
    {"restart initial initialstate initfile input inputfile readdata", "start.file"},
    {"checkpoint checkpointevery checkpointinterval checkpoints", "output.checkpoint_minutes"},
    {"aspect aspectratio", "disks.box_aspect"},
    {"name comment label", "title"},
    {"temp thermostat", "drive.temperature"},
    {"damping kd gamman gammat eta viscosity restitution e en cor coefficientofrestitution", "",
     "the damping follows from disks.elasticity, Q, by k_d = 1/Q; `bagnold validate` tells its "
     "restitution"},
    {"friction mu mus frictioncoefficient coefficientoffriction xmu cof", "",
     "there is no friction between the disks: they repel each other and are damped, by disks.model "
     "and "
     "disks.elasticity; mu = sigma/p is measured"},
    {"steps nsteps numsteps numberofsteps run time totaltime maxtime tmax tend endtime duration "
     "runtime",
     "",
     "a run is as long as its shear.strain: strain = shear.strain_rate times the time, and a step "
     "takes "
     "integration.time_step"},
    {"p p0 confiningpressure load pext", "shear.pressure"},
    {"shearstress sigma tau shearforce", "shear.stress"},
    {"stiffness k kn ke kt young youngs youngsmodulus modulus springconstant", "",
     "it is the unit: k_e = 1 where lengths are in d_s and times in tau_e; disks.elasticity is "
     "what is "
     "left to choose"},
    {"rho massdensity materialdensity", "", "masses are given by disks.mass, in units of one"},
    {"box boxlength boxsize l lx ly lz length size width height cell cellsize domain", "",
     "the box follows from disks.count, disks.packing_fraction and disks.box_aspect"},
    {"radius radii diameter diameters d polydispersity sizes sizeratio bidispersity "
     "sizedistribution",
     "", "half the disks have the diameter 1, half 1.4"},
    {"gravity g", "", "there is none"},
    {"dim dims dimension dimensions ndim", "", "all is in two dimensions"},
    {"boundary boundaries bc pbc periodic walls leesedwards", "",
     "the box is periodic, with Lees-Edwards images across the flow"},
    {"threads nthreads numthreads cores ncores cpus ncpus nproc nprocs jobs gpu gpus device "
     "backend omp",
     "", "it is no matter of the scene: give --threads or --backend on the command line"},
};

constexpr Elsewhere tables_elsewhere[] = {
    {"particles particle grains grain discs system model contact contacts material box geometry",
     "disks"},
    {"initial init initialization initialisation", "start"},
    {"flow deformation protocol strain boundary run", "shear"},
    {"simulation integrator dynamics time numerics", "integration"},
    {"measurement measurements observables analysis", "measure"},
    {"dump log io save", "output"},
    {"thermostat bath", "drive"},
};

bool names(Elsewhere const& one, std::string const& word) {
  return (" " + std::string(one.words) + " ").find(" " + word + " ") != std::string::npos;
}

MeantKey meant(std::string key) {
  auto remark = fmt::format("; did you mean {}?", key);
  return {std::move(key), std::move(remark)};
}

template <std::size_t n>
MeantKey meant_elsewhere(Elsewhere const (&list)[n], std::string const& word) {
  for (auto const& one : list)
    if (names(one, bare(word)))
      return one.key.empty() ? MeantKey{"", fmt::format(" ({})", one.why)}
                             : meant(std::string(one.key));
  return {};
}

}  // namespace

MeantKey meant_key(std::string const& wrong, std::vector<std::string> const& keys) {
  auto const last = [](std::string const& key) { return key.substr(key.rfind('.') + 1); };
  auto const table = wrong.substr(0, wrong.size() - last(wrong).size());
  auto const with_last = [&](std::string const& part) {  // in the same table, or in another
    std::string found;
    for (auto const& key : keys)
      if (last(key) == part && (found.empty() || (!table.empty() && key.starts_with(table))))
        found = key;
    return found;
  };
  if (auto const key = with_last(last(wrong)); !key.empty()) return meant(key);
  std::vector<std::string> here, all;
  for (auto const& key : keys) {
    all.push_back(last(key));
    if (!table.empty() && key.starts_with(table)) here.push_back(last(key));
  }
  auto part = nearest_word(last(wrong), here);
  if (!part.empty() && bare(part) == bare(last(wrong))) return meant(with_last(part));
  if (auto known = meant_elsewhere(keys_elsewhere, last(wrong)); !known.remark.empty())
    return known;
  if (part.empty()) part = nearest_word(last(wrong), all);
  if (!part.empty()) return meant(with_last(part));
  return {"", "; inputs/reference.toml shows all keys"};
}

MeantKey meant_key(std::string const& wrong) {
  std::vector<std::string> keys;
  Scene scene;
  for_each_key(scene, [&](Key const& key, auto const&) { keys.emplace_back(key.name); });
  return meant_key(wrong, keys);
}

MeantKey meant_table(std::string const& wrong, std::vector<std::string> const& tables) {
  if (auto const near = nearest_word(wrong, tables); !near.empty()) return meant(near);
  if (auto known = meant_elsewhere(tables_elsewhere, wrong); !known.remark.empty()) return known;
  return {"", fmt::format("; there are {}", fmt::join(tables, ", "))};
}

}  // namespace bagnold
