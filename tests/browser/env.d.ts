/// <reference path="../../www/node_modules/vite/client.d.ts" />
