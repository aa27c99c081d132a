// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What the program writes, read by the libraries that Foxglove itself reads files with.
// Environment: SUREFOOT_TEST_BAGS, the folder that read_bags.cmake fills.
import assert from "node:assert/strict";
import { open, readFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";

import { crc32 } from "@foxglove/crc";
import { Bag } from "@foxglove/rosbag";
import { FileReader } from "@foxglove/rosbag/node.js";
import { parse } from "@foxglove/rosmsg";
import { ros2humble } from "@foxglove/rosmsg-msgs-common";
import { MessageReader as Ros1Reader } from "@foxglove/rosmsg-serialization";
import { MessageReader, MessageWriter } from "@foxglove/rosmsg2-serialization";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { FileHandleReadable } from "@mcap/nodejs";
import { loadDecompressHandlers } from "@mcap/support";

const folder = process.env.SUREFOOT_TEST_BAGS;
const kScans = 50; // read_bags.cmake asks for so many

/** Fields as both our definitions and ROS's own have them. */
const fieldsOf = (definition) =>
  definition.definitions.map((field) => ({
    name: field.name,
    type: field.type.replace("/msg/", "/"),
    isArray: field.isArray ?? false,
    arrayLength: field.arrayLength,
    isConstant: field.isConstant ?? false,
    value: field.value,
  }));

/** All records of a file from front to back; checksums of chunks are compared on the way. */
async function streamed(file) {
  const bytes = await readFile(file);
  const reader = new McapStreamReader({ decompressHandlers: await loadDecompressHandlers() });
  reader.append(bytes);
  const records = [];
  for (let record; (record = reader.nextRecord()); ) records.push(record);
  assert.ok(reader.done(), "a whole file");
  assert.equal(reader.bytesRemaining(), 0);
  return { bytes, records };
}

async function indexed(file) {
  const handle = await open(file);
  const reader = await McapIndexedReader.Initialize({
    readable: new FileHandleReadable(handle),
    decompressHandlers: await loadDecompressHandlers(),
  });
  const messages = [];
  for await (const message of reader.readMessages()) messages.push(message);
  const attachments = [];
  for await (const attachment of reader.readAttachments()) attachments.push(attachment);
  await handle.close();
  return { reader, messages, attachments };
}

/** The checksum of the data section is of all before its record: no reader of theirs compares it. */
function checkDataCrc(bytes, records) {
  const end = records.find((record) => record.type === "DataEnd");
  const footer = records.find((record) => record.type === "Footer");
  const kDataEndBytes = 1 + 8 + 4;
  const before = Number(footer.summaryStart) - kDataEndBytes;
  assert.equal(crc32(bytes.subarray(0, before)), end.dataSectionCrc, "checksum of the data");
}

/** Messages of each topic, decoded by the schema that the file holds. */
function decoded(messages, schemas, channels) {
  const topics = new Map();
  for (const message of messages) {
    const channel = channels.get(message.channelId);
    const schema = schemas.get(channel.schemaId);
    assert.equal(channel.messageEncoding, "cdr");
    assert.equal(schema.encoding, "ros2msg");
    let topic = topics.get(channel.topic);
    if (!topic) {
      const definitions = parse(new TextDecoder().decode(schema.data), { ros2: true });
      topic = { type: schema.name, definitions, messages: [] };
      topic.reader = new MessageReader(definitions);
      topic.writer = new MessageWriter(definitions);
      topics.set(channel.topic, topic);
    }
    const content = topic.reader.readMessage(message.data);
    // Written again by their library it is the same to the last byte: nothing was read beside.
    const again = topic.writer.writeMessage(content);
    assert.ok(
      message.data.byteLength === again.byteLength && Buffer.compare(message.data, again) === 0,
      `${channel.topic}: message ${topic.messages.length} is not what their library writes`,
    );
    topic.messages.push({ logTime: message.logTime, content });
  }
  return topics;
}

/** Definitions in the file are those of ROS 2 Humble, type for type and field for field. */
function checkDefinitions(topic) {
  assert.ok(topic.definitions.length > 1, "with the types that it is made of");
  topic.definitions.forEach((definition) => {
    const full = (definition.name ?? topic.type).replace("/msg/", "/");
    const theirs = ros2humble[full] ?? ros2humble[full.replace("/", "/msg/")];
    assert.ok(theirs, `${full} is a type of ROS 2`);
    assert.deepEqual(fieldsOf(definition), fieldsOf(theirs), full);
  });
}

/** Both readers, all checksums, all messages: the topics of an MCAP file. */
async function topicsOf(file) {
  const { bytes, records } = await streamed(file);
  checkDataCrc(bytes, records);
  const { reader, messages, attachments } = await indexed(file);
  const inStream = records.filter((record) => record.type === "Message");
  assert.equal(inStream.length, messages.length, "both readers find the same messages");
  assert.equal(BigInt(messages.length), reader.statistics.messageCount);
  const topics = decoded(messages, reader.schemasById, reader.channelsById);
  for (const [id, count] of reader.statistics.channelMessageCounts) {
    assert.equal(BigInt(topics.get(reader.channelsById.get(id).topic).messages.length), count);
  }
  for (const topic of topics.values()) checkDefinitions(topic);
  return { topics, attachments, reader };
}

const nanoseconds = (stamp) => BigInt(stamp.sec) * 1_000_000_000n + BigInt(stamp.nanosec);

function checkCloud(cloud) {
  assert.equal(cloud.data.length, cloud.row_step * cloud.height);
  assert.equal(cloud.row_step, cloud.point_step * cloud.width);
  const names = cloud.fields.map((field) => field.name);
  for (const name of ["x", "y", "z"]) assert.ok(names.includes(name), name);
}

test("a run's MCAP file", async () => {
  const { topics, attachments, reader } = await topicsOf(join(folder, "run.mcap"));
  assert.equal(reader.header.profile, "ros2");
  const types = Object.fromEntries([...topics].map(([name, topic]) => [name, topic.type]));
  assert.deepEqual(types, {
    "/surefoot/scan": "sensor_msgs/msg/PointCloud2",
    "/surefoot/local_map": "sensor_msgs/msg/PointCloud2",
    "/surefoot/odometry": "nav_msgs/msg/Odometry",
    "/surefoot/path": "nav_msgs/msg/Path",
    "/tf": "tf2_msgs/msg/TFMessage",
    "/diagnostics": "diagnostic_msgs/msg/DiagnosticArray",
  });
  const of = (name) => topics.get(name).messages.map((message) => message.content);
  for (const name of ["/surefoot/scan", "/surefoot/odometry", "/tf", "/diagnostics"]) {
    assert.equal(of(name).length, kScans, name);
  }
  for (const cloud of [...of("/surefoot/scan"), ...of("/surefoot/local_map")]) checkCloud(cloud);
  of("/surefoot/odometry").forEach((odometry, i) => {
    const { position, orientation } = odometry.pose.pose;
    const { header, child_frame_id, transform } = of("/tf")[i].transforms[0];
    assert.deepEqual([header.frame_id, child_frame_id], ["odom", "lidar"]);
    assert.deepEqual([odometry.header.frame_id, odometry.child_frame_id], ["odom", "lidar"]);
    assert.deepEqual(header.stamp, odometry.header.stamp);
    assert.deepEqual(header.stamp, of("/surefoot/scan")[i].header.stamp);
    assert.deepEqual({ ...transform.translation }, { ...position });
    assert.deepEqual({ ...transform.rotation }, { ...orientation });
    const { x, y, z, w } = orientation;
    assert.ok(Math.abs(Math.hypot(x, y, z, w) - 1) < 1e-12);
    for (let k = 0; k < 6; ++k) assert.ok(odometry.pose.covariance[7 * k] > 0 || i === 0);
  });
  const path = of("/surefoot/path").at(-1);
  assert.equal(path.poses.length, kScans);
  assert.deepEqual(path.poses.at(-1).pose, of("/surefoot/odometry").at(-1).pose.pose);
  assert.deepEqual(
    of("/diagnostics").flatMap((array) => array.status.map((status) => typeof status.level)),
    Array(kScans).fill("number"),
  );
  assert.equal(attachments.length, 1);
  assert.equal(attachments[0].name, "run.yaml");
  assert.match(new TextDecoder().decode(attachments[0].data), /method/);
});

test("a converted MCAP file", async () => {
  const { topics } = await topicsOf(join(folder, "walk.mcap"));
  assert.equal(topics.size, 1);
  const [topic] = topics.values();
  assert.equal(topic.messages.length, kScans);
  for (const { logTime, content } of topic.messages) {
    checkCloud(content);
    assert.ok(nanoseconds(content.header.stamp) <= logTime);
  }
});

test("a converted ROS 1 bag", async () => {
  const bag = new Bag(new FileReader(join(folder, "walk.bag")), { parse: false });
  await bag.open();
  const readers = new Map();
  let count = 0;
  for await (const result of bag.messageIterator()) {
    const connection = bag.connections.get(result.connectionId);
    assert.equal(connection.type, "sensor_msgs/PointCloud2");
    if (!readers.has(result.connectionId)) {
      readers.set(result.connectionId, new Ros1Reader(parse(connection.messageDefinition)));
    }
    checkCloud(readers.get(result.connectionId).readMessage(result.data));
    ++count;
  }
  assert.equal(count, kScans);
});
