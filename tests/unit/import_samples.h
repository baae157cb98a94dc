#pragma once

#include <map>
#include <string>

#include "base/error.h"
#include "files/read_file.h"

/// Scripts in memory.
namespace repose::test {

/// Reads files from memory; FileError for one that is not there. Refers to the files.
inline ReadFile reader_of(const std::map<std::string, std::string>& files) {
  return [&files](const std::string& name) {
    const auto found = files.find(name);
    if (found == files.end()) throw FileError(name + ": cannot open");
    return found->second;
  };
}

/// A triangle in the plane z = 1, as STL.
inline const std::string triangle_stl =
    "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1\nvertex 1 0 1\nvertex 0 1 1\nendloop\nendfacet\nendsolid "
    "t\n";

/// Grains that fall on a floor. Lines 1 to 20; further ones can be appended.
inline const std::string falling =
    "atom_style granular\n"                                                                              // 1
    "boundary f f f\n"                                                                                   // 2
    "units si\n"                                                                                         // 3
    "region box block -0.1 0.1 -0.1 0.1 0 0.4 units box\n"                                               // 4
    "create_box 1 box\n"                                                                                 // 5
    "fix m1 all property/global youngsModulus peratomtype 5e6\n"                                         // 6
    "fix m2 all property/global poissonsRatio peratomtype 0.4\n"                                         // 7
    "fix m3 all property/global coefficientRestitution peratomtypepair 1 0.6\n"                          // 8
    "fix m4 all property/global coefficientFriction peratomtypepair 1 0.3\n"                             // 9
    "pair_style gran model hertz tangential history\n"                                                   // 10
    "timestep 1e-5\n"                                                                                    // 11
    "fix g all gravity 9.81 vector 0 0 -1\n"                                                             // 12
    "fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0\n"                 // 13
    "fix t all particletemplate/sphere 10007 atom_type 1 density constant 2000 radius constant 0.004\n"  // 14
    "fix d all particledistribution/discrete 10009 1 t 1.0\n"                                            // 15
    "region fill block -0.05 0.05 -0.05 0.05 0.05 0.15 units box\n"                                      // 16
    "fix ins all insert/pack seed 10037 distributiontemplate d insert_every once &\n"                    // 17
    "  vel constant 0 0 -0.5 region fill particles_in_region 50\n"                                       // 18
    "fix move all nve/sphere\n"                                                                          // 19
    "run 1000\n";                                                                                        // 20

}  // namespace repose::test
