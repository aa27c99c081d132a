/* SPDX-FileCopyrightText: 2026 The Surefoot authors
 * SPDX-License-Identifier: MIT
 *
 * LiDAR odometry for other languages: the library behind a dozen functions of plain C, in
 * libsurefoot_c.so. What takes text takes UTF-8. Functions that can fail return NULL or nonzero and
 * leave the reason with surefoot_last_error(). Objects belong to one thread at a time. */
#ifndef SUREFOOT_H
#define SUREFOOT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct surefoot_config surefoot_config;
typedef struct surefoot_odometry surefoot_odometry;

/* Values that lie `stride` bytes apart; the arrays of a scan may be columns of one record. */
typedef struct surefoot_column {
  const void* first; /* NULL: there is none */
  ptrdiff_t stride;  /* [bytes] */
} surefoot_column;

typedef struct surefoot_scan {
  int64_t stamp_ns;            /* instant that the times count from; sensor's epoch */
  size_t size;                 /* points */
  surefoot_column points;      /* float[3] each [m], LiDAR frame: x forward, y left, z up */
  surefoot_column times_ns;    /* int32_t, minus stamp_ns; may be NULL */
  surefoot_column intensities; /* float; may be NULL */
  surefoot_column rings;       /* uint16_t, counted from the lowest; may be NULL */
} surefoot_scan;

typedef enum surefoot_status {
  SUREFOOT_OK = 0,
  SUREFOOT_FIRST_SCAN = 1,
  SUREFOOT_DEGENERATE = 2,
  SUREFOOT_TOO_FEW_MATCHES = 3,
  SUREFOOT_DIVERGED = 4,
  SUREFOOT_LOST = 5,
  SUREFOOT_REJECTED = 6
} surefoot_status;

typedef struct surefoot_estimate {
  int32_t status;           /* a surefoot_status */
  int32_t segment;          /* poses of one segment are in one frame */
  int32_t trusted;          /* whether the pose was measured */
  int64_t stamp_ns;         /* mid-scan, the instant of the pose */
  double T_world_lidar[16]; /* row by row [m] */
  double covariance[36];    /* x y z roll pitch yaw in the world's axes about the sensor [m, rad] */
  double twist[6];          /* LiDAR frame [m/s, rad/s] */
  double wrong_probability; /* of the pose; NaN where that is not told */
  int32_t points;           /* valid points of the scan */
  int32_t registered_points;
} surefoot_estimate;

/* "0.1.0" */
const char* surefoot_version(void);
/* What went wrong last in this thread; valid until the next call in it. */
const char* surefoot_last_error(void);

/* Parameters of a method ("surefoot"); NULL: there is none of that name. */
surefoot_config* surefoot_config_new(const char* method);
void surefoot_config_free(surefoot_config* config);
/* As --set takes it: "knots.points", "1500". Nonzero: no such parameter, none that the method reads,
 * or out of range. */
int surefoot_config_set(surefoot_config* config, const char* name, const char* value);
/* The value as text, valid until the next call in this thread; NULL: no such parameter. */
const char* surefoot_config_get(const surefoot_config* config, const char* name);

/* config NULL: the default method. */
surefoot_odometry* surefoot_odometry_new(const surefoot_config* config, int threads);
void surefoot_odometry_free(surefoot_odometry* odometry);
/* Zero also for a scan that cannot be used: its status is SUREFOOT_REJECTED, and
 * surefoot_message() says why. */
int surefoot_add_scan(surefoot_odometry* odometry, const surefoot_scan* scan,
                      surefoot_estimate* estimate);
/* Of the last scan: why it is not ok; "" otherwise. Valid until the next scan. */
const char* surefoot_message(const surefoot_odometry* odometry);
/* The pose at any instant of the last scan, row by row. Nonzero: there was none yet. */
int surefoot_pose_at(const surefoot_odometry* odometry, int64_t instant_ns,
                     double T_world_lidar[16]);
/* Number of the local map's points; the first `capacity` of them are written to xyz (3 each) [m]. */
size_t surefoot_local_map(const surefoot_odometry* odometry, double* xyz, size_t capacity);

#ifdef __cplusplus
}
#endif

#endif
