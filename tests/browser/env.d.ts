/// <reference path="../../www/node_modules/vite/client.d.ts" />
/// <reference path="../../www/src/words/modules.d.ts" />
/// <reference path="../../www/src/lab/published/modules.d.ts" />
