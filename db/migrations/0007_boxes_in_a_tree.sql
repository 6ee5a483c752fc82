-- Boxes in a tree (SQLite's R*Tree): which features may lie in a box is found without reading the
-- boxes of all others. The tree is in single precision, rounded outwards: the tables of boxes stay
-- the truth. A box across 180 degrees goes on to an east beyond 180.
CREATE VIRTUAL TABLE section_tree USING rtree(id, west, east, south, north);
CREATE VIRTUAL TABLE zone_tree USING rtree(id, west, east, south, north);

INSERT INTO section_tree
  SELECT section_id, west, east + 360 * (west > east), south, north FROM section_boxes;
INSERT INTO zone_tree
  SELECT zone_id, west, east + 360 * (west > east), south, north FROM zone_boxes;

CREATE TRIGGER section_box_into_tree AFTER INSERT ON section_boxes BEGIN
  INSERT OR REPLACE INTO section_tree VALUES
    (new.section_id, new.west, new.east + 360 * (new.west > new.east), new.south, new.north);
END;
CREATE TRIGGER section_box_out_of_tree AFTER DELETE ON section_boxes BEGIN
  DELETE FROM section_tree WHERE id = old.section_id;
END;
CREATE TRIGGER zone_box_into_tree AFTER INSERT ON zone_boxes BEGIN
  INSERT OR REPLACE INTO zone_tree VALUES
    (new.zone_id, new.west, new.east + 360 * (new.west > new.east), new.south, new.north);
END;
CREATE TRIGGER zone_box_out_of_tree AFTER DELETE ON zone_boxes BEGIN
  DELETE FROM zone_tree WHERE id = old.zone_id;
END;

-- The sections of a job in their order, and which of them wait, without reading a row of them.
CREATE INDEX sections_in_order ON sections (job_id, id, state);
