// The Point Cloud Library on the workload of our benches: rays through occupied cells.
//
//     g++ -O3 -march=native benches/peers/pcl.cpp $(pkg-config --cflags --libs pcl_octree) -o pcl
//     pcl NAME DEPTH CELLS RAYS
//
// Its OctreePointCloudSearch walks by the parametric algorithm [Revelles 2000], with the
// means of planes, over occupied cells only. Every cell holds one point, its centre. `enum`
// asks for all cells on a ray, in order, `first` for at most one.

#include "workload.hpp"
#include <cmath>
#include <pcl/octree/octree_search.h>
#include <pcl/point_types.h>

using Octree = pcl::octree::OctreePointCloudSearch<pcl::PointXYZ>;

static Eigen::Vector3f vector(const double (&numbers)[3]) {
    return {float(numbers[0]), float(numbers[1]), float(numbers[2])};
}

int main(int count, char **arguments) {
    const Workload workload = load(count, arguments);
    const double side = std::pow(2.0, -workload.depth);
    pcl::PointCloud<pcl::PointXYZ>::Ptr centres(new pcl::PointCloud<pcl::PointXYZ>);
    for (const auto &cell : workload.cells) {
        const auto middle = [&](int e) { return float((cell[e] + 0.5) * side); };
        centres->push_back({middle(0), middle(1), middle(2)});
    }
    Octree tree(side);
    tree.defineBoundingBox(0.0, 0.0, 0.0, 1.0, 1.0, 1.0);
    tree.setInputCloud(centres);
    tree.addPointsFromInputCloud();

    pcl::Indices found;
    const auto cells = [&](const Ray &ray, unsigned most) {
        return long(tree.getIntersectedVoxelIndices(vector(ray.origin), vector(ray.direction),
                                                    found, most));
    };
    measure("enum", workload, [&](const Ray &ray) { return cells(ray, 0); });
    measure("first", workload, [&](const Ray &ray) { return cells(ray, 1); });
}
