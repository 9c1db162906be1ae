BEGIN TRANSACTION;
CREATE TABLE origin(session TEXT NOT NULL,save TEXT NOT NULL);
INSERT INTO "origin" VALUES('66394922147a47f3a757640969192463','a227cfd75cda47de8fcf043fac0ef5c8');
CREATE TABLE steps(number INTEGER PRIMARY KEY,act TEXT NOT NULL,edit INTEGER NOT NULL,time TEXT NOT NULL,author TEXT NOT NULL,kind TEXT NOT NULL,text TEXT NOT NULL,frame INTEGER NOT NULL,before TEXT NOT NULL,after TEXT NOT NULL,undoes INTEGER NOT NULL DEFAULT 0,scope TEXT NOT NULL DEFAULT '',checksum TEXT NOT NULL DEFAULT '');
INSERT INTO "steps" VALUES(1,'apply',9,'2026-11-23T20:56:49.708+00:00','ada','swap','Swap 2 and 3 from frame 12 on',12,'{"stretches":[[2,12,30],[3,12,30]]}','{"stretches":[[3,12,30],[2,12,30]]}',0,'12:','f523ff93a0a1310a');
INSERT INTO "steps" VALUES(2,'apply',10,'2026-11-23T20:56:49.713+00:00','ada','split','Split 1 at frame 20; the rest is 5',20,'{"stretches":[[1,20,30]]}','{"stretches":[[5,20,30]]}',0,'20:','e4ff8430b5149138');
INSERT INTO "steps" VALUES(3,'undo',10,'2026-11-23T20:56:49.713+00:00','ada','split','Split 1 at frame 20; the rest is 5',20,'','',0,'20:','2d0dae099d6bbf58');
COMMIT;
