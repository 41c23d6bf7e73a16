#pragma once

/// One function for every algorithm that can be demonstrated: it runs the engine's own code with an observer and tells
/// the events as a story. Each lies in a file of its own and may rely on what demonstration.cpp has checked.

#include "scenarios/demonstration.h"

namespace proofreel {

Story tell_gift_wrapping(const Demonstration& demonstration);
Story tell_separating_axes(const Demonstration& demonstration);
Story tell_gjk_epa(const Demonstration& demonstration);
Story tell_tree_insertion(const Demonstration& demonstration);
Story tell_tree_pairs(const Demonstration& demonstration);
Story tell_diagonal_test(const Demonstration& demonstration);
Story tell_edge_walk(const Demonstration& demonstration);
Story tell_centroid(const Demonstration& demonstration);
Story tell_circle_contact(const Demonstration& demonstration);
Story tell_bounding_volumes(const Demonstration& demonstration);
Story tell_dot_product(const Demonstration& demonstration);
Story tell_cross_product(const Demonstration& demonstration);
Story tell_transforms(const Demonstration& demonstration);
Story tell_transform_order(const Demonstration& demonstration);
Story tell_gjk_line(const Demonstration& demonstration);
Story tell_center_of_mass(const Demonstration& demonstration);
Story tell_moment_of_inertia(const Demonstration& demonstration);
Story tell_friction_cone(const Demonstration& demonstration);
Story tell_sequential_impulses(const Demonstration& demonstration);

}  // namespace proofreel
