// OctoMap on the workload of our benches: rays through occupied cells.
//
//     g++ -O3 -march=native benches/peers/octomap.cpp $(pkg-config --cflags --libs octomap) -o octomap
//     octomap NAME DEPTH CELLS RAYS
//
// Prints two rows as the other benches do: `enum` lists the cells of the finest grid on a
// ray inside the unit cube and looks each of them up; `first` is OctoMap's own castRay
// through unknown space, from where the ray enters the cube.

#include "workload.hpp"
#include <cmath>
#include <octomap/octomap.h>

using octomap::OcTree;
using octomap::point3d;

// Where the ray is in the unit cube: from and to; false if nowhere.
static bool clip(const Ray &ray, double &from, double &to) {
    from = 0.0, to = 1e9;
    for (int e = 0; e < 3; ++e) {
        double o = ray.origin[e], d = ray.direction[e];
        if (d == 0.0) {
            if (o < 0.0 || o >= 1.0) return false;
            continue;
        }
        double a = -o / d, b = (1.0 - o) / d;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from < to;
}

static point3d at(const Ray &ray, double t) {
    return point3d(float(ray.origin[0] + t * ray.direction[0]),
                   float(ray.origin[1] + t * ray.direction[1]),
                   float(ray.origin[2] + t * ray.direction[2]));
}

static long enumerate(const OcTree &tree, const Ray &ray, octomap::KeyRay &keys) {
    double from, to;
    if (!clip(ray, from, to) || !tree.computeRayKeys(at(ray, from), at(ray, to), keys)) return 0;
    long full = 0;
    for (const auto &key : keys) full += tree.search(key) != nullptr;
    return full;
}

static long first(const OcTree &tree, const Ray &ray) {
    double from, to;
    if (!clip(ray, from, to)) return 0;
    point3d direction(float(ray.direction[0]), float(ray.direction[1]), float(ray.direction[2]));
    point3d end;
    return tree.castRay(at(ray, from), direction, end, true, 2.0);
}

int main(int count, char **arguments) {
    const Workload workload = load(count, arguments);
    OcTree tree(std::pow(2.0, -workload.depth));
    const unsigned middle = 32768;
    for (const auto &cell : workload.cells) {
        octomap::OcTreeKey key(middle + unsigned(cell[0]), middle + unsigned(cell[1]),
                               middle + unsigned(cell[2]));
        tree.setNodeValue(key, 2.0f, true);
    }
    tree.updateInnerOccupancy();
    octomap::KeyRay keys;
    measure("enum", workload, [&](const Ray &ray) { return enumerate(tree, ray, keys); });
    measure("first", workload, [&](const Ray &ray) { return first(tree, ray); });
}
