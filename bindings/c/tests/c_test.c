/* SPDX-FileCopyrightText: 2026 The Surefoot authors
 * SPDX-License-Identifier: MIT
 *
 * What a program in C does: a sensor moves through a room, 2 cm a scan. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "surefoot.h"

#define CHECK(condition)                                                        \
  do {                                                                          \
    if (!(condition)) {                                                         \
      fprintf(stderr, "%s:%d: %s does not hold\n", __FILE__, __LINE__, #condition); \
      exit(1);                                                                  \
    }                                                                           \
  } while (0)

enum { kColumns = 900, kLasers = 16, kPoints = kColumns * kLasers };

/* As a driver's message has it: one record a point. */
struct record {
  float x, y, z;
  unsigned short ring;
  int time_ns;
};

static double wall(double origin, double direction, double near, double far) {
  if (direction > 0) return (far - origin) / direction;
  if (direction < 0) return (near - origin) / direction;
  return HUGE_VAL;
}

static void measure(double x, struct record* records) {
  const double degree = acos(-1.0) / 180.0;
  for (int i = 0; i < kPoints; ++i) {
    const double azimuth = 0.4 * degree * (i / kLasers);
    const double elevation = degree * (2.0 * (i % kLasers) - 15.0);
    const double ray[3] = {cos(elevation) * cos(azimuth), cos(elevation) * sin(azimuth),
                           sin(elevation)};
    const double range = fmin(fmin(wall(x, ray[0], -4, 4), wall(0.5, ray[1], -3, 3)),
                              wall(0.2, ray[2], -1, 2));
    records[i].x = (float)(range * ray[0]);
    records[i].y = (float)(range * ray[1]);
    records[i].z = (float)(range * ray[2]);
    records[i].ring = (unsigned short)(i % kLasers);
    records[i].time_ns = i / kLasers * 110000;
  }
}

static void walk(surefoot_odometry* odometry) {
  struct record* records = malloc(kPoints * sizeof(*records));
  surefoot_estimate estimate;
  double pose[16];
  CHECK(surefoot_pose_at(odometry, 0, pose) != 0);
  for (int k = 0; k < 10; ++k) {
    measure(0.02 * k, records);
    surefoot_scan scan;
    memset(&scan, 0, sizeof(scan));
    scan.stamp_ns = 100000000LL * k;
    scan.size = kPoints;
    scan.points.first = &records->x;
    scan.times_ns.first = &records->time_ns;
    scan.rings.first = &records->ring;
    scan.points.stride = scan.times_ns.stride = scan.rings.stride = sizeof(*records);
    CHECK(surefoot_add_scan(odometry, &scan, &estimate) == 0);
    CHECK(estimate.trusted);
    CHECK(k > 0 || estimate.status == SUREFOOT_FIRST_SCAN);
  }
  CHECK(fabs(estimate.T_world_lidar[3] - 0.18) < 0.02);
  CHECK(estimate.T_world_lidar[15] == 1.0);
  CHECK(estimate.covariance[0] > 0.0);
  CHECK(surefoot_pose_at(odometry, estimate.stamp_ns, pose) == 0);
  CHECK(fabs(pose[3] - estimate.T_world_lidar[3]) < 1e-9);
  free(records);
}

static void refuse_null(void) {
  surefoot_config* config = surefoot_config_new(NULL);
  surefoot_odometry* odometry = surefoot_odometry_new(NULL, 1);
  surefoot_scan scan;
  double pose[16];
  memset(&scan, 0, sizeof(scan));
  CHECK(surefoot_config_set(NULL, "level.mode", "none") != 0);
  CHECK(surefoot_config_set(config, NULL, "none") != 0);
  CHECK(surefoot_config_set(config, "level.mode", NULL) != 0);
  CHECK(strstr(surefoot_last_error(), "surefoot_config_set: got NULL") != NULL);
  CHECK(surefoot_config_get(NULL, "level.mode") == NULL);
  CHECK(surefoot_config_get(config, NULL) == NULL);
  CHECK(surefoot_add_scan(NULL, &scan, NULL) != 0);
  CHECK(surefoot_add_scan(odometry, NULL, NULL) != 0);
  CHECK(surefoot_pose_at(NULL, 0, pose) != 0);
  CHECK(surefoot_local_map(NULL, NULL, 0) == 0);
  CHECK(strlen(surefoot_message(NULL)) == 0);
  surefoot_config_free(config);
  surefoot_odometry_free(odometry);
}

int main(void) {
  CHECK(strlen(surefoot_version()) > 0);
  CHECK(surefoot_config_new("fast") == NULL);
  CHECK(strstr(surefoot_last_error(), "fast") != NULL);

  surefoot_config* config = surefoot_config_new("surefoot");
  CHECK(config != NULL);
  CHECK(surefoot_config_set(config, "level.mode", "none") == 0);
  CHECK(strcmp(surefoot_config_get(config, "level.mode"), "none") == 0);
  CHECK(surefoot_config_set(config, "knots.points", "-1") != 0);
  CHECK(strstr(surefoot_last_error(), "knots.points: got '-1', expected") != NULL);
  CHECK(surefoot_config_get(config, "no.such") == NULL);
  CHECK(surefoot_config_set(config, "no.such", "1") != 0);
  CHECK(strstr(surefoot_last_error(), "no.such") != NULL);
  CHECK(surefoot_config_set(config, "kiss_icp.voxel_size", "1") != 0);
  CHECK(strstr(surefoot_last_error(), "method surefoot does not read it") != NULL);

  surefoot_odometry* odometry = surefoot_odometry_new(config, 1);
  CHECK(odometry != NULL);
  surefoot_config_free(config);
  walk(odometry);

  refuse_null();

  surefoot_scan nothing;
  memset(&nothing, 0, sizeof(nothing));
  surefoot_estimate estimate;
  CHECK(surefoot_add_scan(odometry, &nothing, &estimate) == 0);
  CHECK(estimate.status == SUREFOOT_REJECTED && !estimate.trusted);
  CHECK(strstr(surefoot_message(odometry), "expected") != NULL);

  const size_t size = surefoot_local_map(odometry, NULL, 0);
  CHECK(size > 100);
  double first[3] = {0, 0, 0};
  CHECK(surefoot_local_map(odometry, first, 1) == size);
  CHECK(first[0] != 0.0);
  surefoot_odometry_free(odometry);
  surefoot_odometry_free(NULL);
  surefoot_config_free(NULL);
  printf("all well with surefoot %s\n", surefoot_version());
  return 0;
}
