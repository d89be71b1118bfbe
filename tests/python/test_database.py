"""Database and Decimation: adjacencies, edits, history, reasons."""

import numpy as np
import pytest

import aomd

SQUARE = aomd.Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])


def test_counts_and_ids():
    database = aomd.Database(SQUARE)
    assert [database.count(dim) for dim in range(4)] == [4, 0, 2, 0]
    np.testing.assert_array_equal(database.ids(2), [0, 1])
    np.testing.assert_array_equal(database.positions(), SQUARE.vertices)
    with pytest.raises(ValueError):
        database.count(4)


def test_the_tensor_changes_at_run_time():
    database = aomd.Database(SQUARE)
    assert database.tensor().sum() == 1 and database.tensor()[2, 0]
    with pytest.raises(RuntimeError, match="request|T"):
        database.adjacent(0, 0, 2)
    database.store(0, 2)
    np.testing.assert_array_equal(database.adjacent(0, 0, 2), [0, 1])
    np.testing.assert_array_equal(database.adjacent(0, 1, 2), [0])
    assert database.explain(0, 2) != ""
    database.store(0, 1)
    assert database.count(1) == 5
    database.release(0, 2)
    assert not database.tensor()[0, 2]
    with pytest.raises(RuntimeError):
        database.release(2, 0)
    with pytest.raises(ValueError, match="two different levels"):
        database.adjacent(0, 0, 0)


def test_relations_as_arrays():
    database = aomd.Database(SQUARE)
    database.store(0, 2)
    offsets, entries = database.relation(0, 2)
    assert offsets.tolist() == [0, 2, 3, 5, 6] and entries.tolist() == [0, 1, 0, 0, 1, 1]
    offsets, entries = database.relation(2, 0)
    assert offsets.tolist() == [0, 3, 6] and entries.tolist() == [0, 1, 2, 0, 2, 3]


def test_finding():
    database = aomd.Database(SQUARE)
    database.store(0, 1)
    edge = database.find(1, [2, 0])
    assert sorted(database.vertices_of(1, edge)) == [0, 2]
    assert database.find(1, [1, 3]) is None
    assert database.find(2, [2, 1, 0]) == 0
    assert database.users(1, edge) == [(2, 0), (2, 1)]
    with pytest.raises(IndexError, match="there is no vertex 9"):
        database.find(1, [0, 9])


def test_edits_and_history():
    database = aomd.Database(SQUARE)
    with pytest.raises(RuntimeError, match="nothing is recorded"):
        database.undo()
    database.record()
    vertex = database.create_vertex([2, 0, 0], (0, 7))
    face = database.create(2, [1, vertex, 2])
    database.move(vertex, [3, 0, 0])
    assert (vertex, face, database.steps, database.cursor) == (4, 2, 3, 3)
    assert database.classification(0, vertex) == (0, 7) and database.classification(0, 0) is None
    with pytest.raises(RuntimeError, match="face 2"):
        database.destroy(0, vertex)
    with pytest.raises(ValueError):
        database.set_classification(2, face, (1, 3))
    assert database.undo() and database.positions()[vertex].tolist() == [2, 0, 0]
    database.seek(0)
    assert database.count(2) == 2 and not database.undo()
    assert database.redo() and database.cursor == 1
    database.seek(3)
    assert database.to_mesh().vertices[vertex].tolist() == [3, 0, 0]
    assert database.step(1) == ("edit", None)
    database.destroy(0, vertex, with_users=True)
    assert database.count(2) == 2
    assert database.verify() == []


def ball():
    database = aomd.Database(aomd.sample("sphere"))
    database.classify()
    return database


def test_decimation_step_by_step_and_back():
    database = ball()
    database.store(0, 1)
    start = database.to_mesh()
    database.record()
    decimation = aomd.Decimation(database, target_faces=100)
    kind, entity = decimation.step()
    assert (kind, database.steps) == ("collapse", 1) and entity == database.step(0)[1]
    assert decimation.phase == "collapse" and not decimation.done
    assert decimation.run()
    assert decimation.done and decimation.step() is None and database.count(2) == 100
    assert decimation.sweeps[0]["collapses"] > 0
    end = database.to_mesh()
    database.seek(0)
    assert database.to_mesh() == start
    database.seek(database.steps)
    assert database.to_mesh() == end
    assert database.verify() == []


def test_a_decimation_goes_on_after_undoing():
    database = ball()
    database.store(0, 1)
    database.record()
    decimation = aomd.Decimation(database, target_faces=100)
    decimation.run()
    database.seek(10)
    assert not decimation.done
    assert decimation.run() and database.count(2) == 100


def test_reasons():
    database = aomd.Database(aomd.sample("bracket"))
    database.classify()
    database.store(0, 1)
    decimation = aomd.Decimation(database, strategy="paper", factor=2)
    decimation.run()
    reasons = decimation.edges_left()
    assert reasons and all(count > 0 for count in reasons.values())
    assert decimation.why_stopped().startswith("Stopped")
    edge = int(database.ids(1)[0])
    verdict = decimation.judge(edge)
    assert not verdict["accepted"] and verdict["reason"]
    assert decimation.why_swap(edge).endswith(".") and decimation.why_move(0).endswith(".")
    sentences = decimation.why(edge)
    assert sentences and all(sentence.endswith(".") for sentence in sentences)
    with pytest.raises(IndexError):
        decimation.why(10 ** 8)


def test_passes_and_pauses():
    database = ball()
    database.store(0, 1)
    decimation = aomd.Decimation(database, strategy="paper", factor=2)
    assert decimation.sweep() > 0
    assert decimation.swap() >= 0 and decimation.smooth() >= 0
    decimation.run(seconds=0.0)
    assert 0 <= decimation.progress <= 1


def test_a_database_that_is_not_classified_is_refused():
    mesh = aomd.sample("bracket")
    wrong = aomd.Mesh(mesh.vertices, mesh.faces,
                      classes={"faces": np.full(len(mesh.faces), 1),
                               "vertices": [[3, 1]] * len(mesh.vertices)})
    with pytest.raises(ValueError):
        aomd.Decimation(aomd.Database(wrong), target_faces=10)


def test_memory():
    database = ball()
    entities, adjacencies = database.memory()
    database.store(0, 2)
    assert entities > 0 and database.memory()[1] > adjacencies
